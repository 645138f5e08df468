package org.u2sa.vision.ground;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Height that the vehicle has climbed on a slope, such as a ramp, above the level ground before it:
 * the ground beyond may be that much lower. Ends on ground that is level for longer than a ramp's
 * top, and at the height where the slope began.
 */
public final class ClimbedHeight {
  private static final double LEVEL_M = 2.5; // longest top of a ramp
  private static final double HIGHEST_M = 0.6; // ramp
  private static final double GAP_S = 1.0; // without states

  private final double slopeAboveRad;
  private long micros = Long.MIN_VALUE;
  private double climbedM;
  private double levelM; // driven since the slope

  /**
   * @param slopeAboveRad pitch up to which the ground counts as level
   */
  public ClimbedHeight(double slopeAboveRad) {
    this.slopeAboveRad = slopeAboveRad;
  }

  /**
   * Adds a state; ignored without time, pitch, heading or velocity, in another frame than GLOBAL,
   * and if it is older than the last.
   */
  public void add(StateInformation state) {
    boolean isComplete =
        state.referenceFrame().equals(ReferenceFrame.GLOBAL)
            && state.timestamp().isPresent()
            && state.theta().isPresent()
            && state.psi().isPresent()
            && state.xDot().isPresent()
            && state.yDot().isPresent();
    if (!isComplete) {
      return;
    }
    long now = state.timestamp().orElseThrow();
    double seconds = micros == Long.MIN_VALUE ? 0.0 : Clock.seconds(now - micros);
    if (seconds < 0.0 && seconds >= -GAP_S) {
      return; // late; after a longer step back, the clock was set
    }
    micros = now;
    if (seconds <= 0.0 || seconds > GAP_S) {
      return;
    }
    double psi = state.psi().getAsDouble();
    double forward =
        state.xDot().getAsDouble() * StrictMath.sin(psi)
            + state.yDot().getAsDouble() * StrictMath.cos(psi);
    drive(forward * seconds, state.theta().getAsDouble());
  }

  private void drive(double metres, double pitchRad) {
    if (Math.abs(pitchRad) > slopeAboveRad) {
      climbedM = Math.max(0.0, climbedM + metres * StrictMath.sin(pitchRad));
      levelM = 0.0;
      return;
    }
    levelM += Math.abs(metres);
    if (levelM > LEVEL_M) {
      climbedM = 0.0;
    }
  }

  /**
   * Height [m]; 0 on level ground, below where the slope began, and on a hill, which is higher than
   * a ramp: the ground before it is far behind.
   */
  public double metres() {
    return climbedM <= HIGHEST_M ? climbedM : 0.0;
  }
}
