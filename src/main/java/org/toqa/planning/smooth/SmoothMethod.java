package org.toqa.planning.smooth;

/** What plans: both, or, to see what each does, one alone. */
public enum SmoothMethod {
  /** The tree as it is: no path of it is pulled taut. */
  RRT_STAR,

  /** A swarm that begins with random way points, and pulls taut what it finds. */
  PARTICLE_SWARM,

  /** The tree finds, the swarm and the shortener improve, and what they reach leads the tree. */
  HYBRID
}
