package org.u2sa.core.control.ground;

import java.util.Locale;
import java.util.Optional;

/**
 * Detects stalled motors: full command without the demanded motion, from too heavy a load, too
 * steep a slope, an obstacle or no supply. Stalled motors burn, so it lets them rest. Belongs to
 * one thread.
 */
final class MotionWatch {
  private static final double FULL_EFFORT = 0.98;
  private static final double MOVES_SHARE = 0.1; // of what is demanded
  private static final double ROLLS_MPS = 0.1;

  private double heldS;
  private double turnedRad;
  private double goneM;
  private double restS;
  private double quietS; // until it says again what goes on without a rest
  private boolean rolls; // when its motors rest, until it has moved as it is to

  /**
   * What was demanded of the motors, and what became of it, since the call before.
   *
   * @param afterS how long they may try [s]
   * @param pauseS how long they rest then [s]
   * @param effort of the motors, 1 and more if they give all
   * @return what to tell the user, once for each attempt, or each pause without one
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
    boolean moved =
        turns
            ? Math.abs(turnedRad) > MOVES_SHARE * heldS * Math.abs(demanded.yawRateRadPerS())
            : goneM > MOVES_SHARE * heldS * demanded.speedMps();
    String words =
        String.format(
            Locale.ROOT,
            "the motors cannot %s this load here: in %.1f s at full power it %s",
            turns ? "turn" : "move",
            heldS,
            turns
                ? String.format(Locale.ROOT, "turned by %.0f degrees", Math.toDegrees(turnedRad))
                : String.format(Locale.ROOT, "went %.2f m", goneM));
    rolls |= !turns && goneM < -ROLLS_MPS * heldS;
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
                ? "; they go on, for at rest it would roll away"
                : "; they rest, then it tries again"));
  }

  private void forget() {
    heldS = 0.0;
    turnedRad = 0.0;
    goneM = 0.0;
  }

  /** Whether the motors are to rest. On a slope they do not: there is no other brake. */
  boolean rests(GroundControl.Measured measured, double stepS) {
    restS = Math.max(0.0, restS - stepS);
    if (restS > 0.0 && Math.abs(measured.forwardMps().orElse(0.0)) > ROLLS_MPS) {
      rolls = true;
      restS = 0.0;
    }
    return restS > 0.0;
  }
}
