package org.u2sa.scenarios.ugv;

import org.u2sa.sim.ground.Surface;

/** What the demo drives on. */
enum GroundKind {
  /** Trodden earth and short grass. */
  LAWN(Surface.lawn()),
  /** Dry concrete. */
  CONCRETE(Surface.concrete()),
  /** Wet and soft. */
  FIELD(Surface.field());

  private final Surface surface;

  GroundKind(Surface surface) {
    this.surface = surface;
  }

  Surface surface() {
    return surface;
  }
}
