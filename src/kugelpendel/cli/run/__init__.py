"""kugelpendel run: the main job, of an ideal or a real pendulum."""
