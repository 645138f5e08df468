package org.u2sa.control.ground;

import java.util.Locale;
import java.util.Optional;

/**
 * Detects stalled motors: full command without the demanded motion, caused by overload, a steep
 * slope, an obstacle or missing power. Rests stalled motors so that they do not burn out. Not
 * thread-safe.
 */
final class MotionWatch {
  private static final double FULL_EFFORT = 0.98;
  private static final double MOVES_SHARE =
      0.1; // fraction of the demanded speed that counts as moving
  private static final double ROLLS_MPS = 0.1;

  private double heldS;
  private double turnedRad;
  private double goneM;
  private double restS;
  private double quietS; // time until the next warning when not resting
  private boolean rolls; // when motors rest; reset once the vehicle has moved as demanded

  /**
   * Updates with the demand on the motors and the resulting motion since the previous call.
   *
   * @param afterS maximum stall time before motors rest [s]
   * @param pauseS duration of the rest [s]
   * @param effort effort of the motors; 1 or more at full power
   * @return warning for the user, once per attempt, or once per pause without rest
   */
  Optional<String> see(
      Drive demanded,
      GroundControl.Measured measured,
      double effort,
      double afterS,
      double pauseS,
      double stepS) {
    quietS = Math.max(0.0, quietS - stepS);
    boolean known =
        measured.forwardMps().isPresent() && measured.yawRateRadPerS().isPresent() && stepS > 0.0;
    if (effort < FULL_EFFORT || !known) {
      forget();
      return Optional.empty();
    }
    heldS += stepS;
    turnedRad += measured.yawRateRadPerS().getAsDouble() * stepS;
    goneM += measured.forwardMps().getAsDouble() * stepS;
    if (heldS < afterS) {
      return Optional.empty();
    }
    boolean turns = demanded.speedMps() == 0.0;
    double aheadM = Math.signum(demanded.speedMps()) * goneM; // in the demanded direction
    boolean moved =
        turns
            ? Math.abs(turnedRad) > MOVES_SHARE * heldS * Math.abs(demanded.yawRateRadPerS())
            : aheadM > MOVES_SHARE * heldS * Math.abs(demanded.speedMps());
    String words =
        String.format(
            Locale.ROOT,
            "the motors cannot %s this load here: in %.1f s at full power it %s",
            turns ? "turn" : "move",
            heldS,
            turns
                ? String.format(Locale.ROOT, "turned by %.0f degrees", Math.toDegrees(turnedRad))
                : String.format(Locale.ROOT, "went %.2f m", aheadM));
    rolls |= !turns && aheadM < -ROLLS_MPS * heldS;
    forget();
    if (moved) {
      rolls = false;
      return Optional.empty();
    }
    if (rolls && quietS > 0.0) {
      return Optional.empty();
    }
    restS = rolls ? 0.0 : pauseS;
    quietS = pauseS;
    return Optional.of(
        words
            + (rolls
                ? "; they stay on, because at rest the vehicle would roll away"
                : "; they rest before the next attempt"));
  }

  private void forget() {
    heldS = 0.0;
    turnedRad = 0.0;
    goneM = 0.0;
  }

  /** Whether the motors must rest. Never on a slope, where the motors are the only brake. */
  boolean rests(GroundControl.Measured measured, double stepS) {
    restS = Math.max(0.0, restS - stepS);
    if (restS > 0.0 && Math.abs(measured.forwardMps().orElse(0.0)) > ROLLS_MPS) {
      rolls = true;
      restS = 0.0;
    }
    return restS > 0.0;
  }
}
