package org.u2sa.messages;

import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Signs (1 or -1) of y, z and the senses of rotation: of a BODY frame relative to BODY_FRD, or
 * between two BODY frames. All have the same x.
 */
record BodySigns(double y, double z, double phi, double theta, double psi) {
  private static final BodySigns FRD = new BodySigns(1.0, 1.0, 1.0, 1.0, 1.0);
  // Thesis 3.2.3.2: phi from the left axis' view rolls towards +y (left), theta away from +z is
  // nose up, psi from +x to +y.
  private static final BodySigns THESIS = new BodySigns(-1.0, 1.0, -1.0, 1.0, -1.0);
  private static final BodySigns FLU = new BodySigns(-1.0, -1.0, 1.0, -1.0, -1.0);

  /** Factors that convert values from one BODY frame to another. */
  static BodySigns between(ReferenceFrame from, ReferenceFrame to) {
    BodySigns a = of(from);
    BodySigns b = of(to);
    return new BodySigns(a.y * b.y, a.z * b.z, a.phi * b.phi, a.theta * b.theta, a.psi * b.psi);
  }

  /** Signs of a BODY frame relative to BODY_FRD. */
  static BodySigns of(ReferenceFrame frame) {
    if (frame.equals(ReferenceFrame.BODY_FRD)) {
      return FRD;
    }
    return frame.equals(ReferenceFrame.BODY) ? THESIS : FLU;
  }
}
