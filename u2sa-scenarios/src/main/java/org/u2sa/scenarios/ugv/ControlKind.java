package org.u2sa.scenarios.ugv;

/** Which control drives in the demo. */
enum ControlKind {
  /** Regulated pure pursuit. */
  PURSUIT,
  /** The thesis's proportional controller for each wheel; of differential vehicles only. */
  PROPORTIONAL
}
