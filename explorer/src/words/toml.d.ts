/** A file of sentences as the build makes it a module. */
declare module "*.toml" {
  const sentences: import("./sentences").Sentences;
  export default sentences;
}
