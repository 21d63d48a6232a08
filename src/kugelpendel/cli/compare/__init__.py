"""kugelpendel compare: all motions of the paper beside the exact one."""
