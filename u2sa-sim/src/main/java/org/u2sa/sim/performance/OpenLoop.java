package org.u2sa.sim.performance;

import java.util.Arrays;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Simulates a vehicle with constant commands until its motion is steady. */
public final class OpenLoop {
  /** Longest simulated time [s]. */
  public static final double LONGEST_S = 5_120.0;

  private static final double TICK_S = 0.05;
  private static final double FIRST_S = 5.0; // the time doubles until the motion is steady
  private static final double STEADY = 0.005; // change within the second half, relative
  private static final double EQUAL = 1.1;
  private static final double CALM_RADPS = 0.002; // turns that do not matter when driving straight
  private static final double FASTEST_MPS = 1_000.0;
  private static final double OVERTURNED_RAD = Math.toRadians(60.0);

  /** How a simulation ended. */
  public enum End {
    /** The motion is steady. */
    STEADY,
    /** The motion still changes after the longest time. */
    CHANGING,
    /** It changes to and fro, equally in times that double. */
    OSCILLATING,
    /** It has rolled or pitched over. */
    OVERTURNED,
    /** It is faster than any vehicle; forces, masses and drag do not fit each other. */
    DIVERGED
  }

  /**
   * A simulated motion.
   *
   * @param peak largest acceleration along the axis [m/s²], [rad/s²]
   * @param fastest largest velocity along the axis [m/s], [rad/s]
   * @param last velocity along the axis at the end [m/s], [rad/s]
   * @param speedMps horizontal speed at the end
   * @param yawRadPerS yaw rate at the end
   */
  public record Motion(
      End end, double peak, double fastest, double last, double speedMps, double yawRadPerS) {
    /** Whether it ended in a steady motion. */
    public boolean isSteady() {
      return end == End.STEADY;
    }

    /** Radius of the circle at the end [m]; infinite if it does not turn. */
    public double radiusM() {
      return yawRadPerS == 0.0 ? Double.POSITIVE_INFINITY : speedMps / Math.abs(yawRadPerS);
    }
  }

  private final MotionAxis axis;
  private final double sign;
  private double peak;
  private double fastest;

  private OpenLoop(MotionAxis axis, double sign) {
    this.axis = axis;
    this.sign = sign;
  }

  /**
   * Runs a vehicle that has its commands.
   *
   * @param sign direction along the axis that counts as positive, 1 or −1
   */
  public static Motion run(SimulatedVehicle vehicle, MotionAxis axis, double sign) {
    return run(vehicle, axis, sign, LONGEST_S);
  }

  /** Like the other method, but simulates a shorter time at most. */
  public static Motion run(
      SimulatedVehicle vehicle, MotionAxis axis, double sign, double longestS) {
    return new OpenLoop(axis, sign).run(vehicle, longestS);
  }

  private Motion run(SimulatedVehicle vehicle, double longestS) {
    VehicleTruth last = vehicle.truth();
    double[] now = MotionAxis.velocities(last);
    End end = End.CHANGING;
    double[] swings = {0.0, 0.0, 0.0}; // of the last times
    long done = 0;
    for (double until = FIRST_S; end == End.CHANGING && until <= longestS; until *= 2.0) {
      double[] least = now.clone();
      double[] most = now.clone();
      for (; done < Math.round(until / TICK_S) && end == End.CHANGING; done++) {
        double[] before = now;
        if (vehicle instanceof GroundVehicle ground) {
          ground.charge(1.0); // full; it would grow slower all the time
        }
        try {
          vehicle.step(TICK_S);
          last = vehicle.truth();
        } catch (IllegalArgumentException e) { // a state that is not finite
          end = End.DIVERGED;
          break;
        }
        now = MotionAxis.velocities(last);
        peak = Math.max(peak, sign * (now[axis.ordinal()] - before[axis.ordinal()]) / TICK_S);
        fastest = Math.max(fastest, sign * now[axis.ordinal()]);
        for (int k = 0; k < now.length; k++) {
          least[k] = Math.min(least[k], now[k]);
          most[k] = Math.max(most[k], now[k]);
        }
        if (last.velocity().distance() > FASTEST_MPS) {
          end = End.DIVERGED;
        } else if (isOver(last.attitude())) {
          end = End.OVERTURNED;
        }
      }
      double drift = length(most, least, MotionAxis.SURGE);
      double turn = length(most, least, MotionAxis.ROLL);
      swings = new double[] {swings[1], swings[2], axis.isRotation() ? turn : drift};
      if (end == End.CHANGING && isSteady(now, drift, turn)) {
        end = End.STEADY;
      } else if (end == End.CHANGING && areEqual(swings)) {
        end = End.OSCILLATING;
      }
    }
    return new Motion(
        end, peak, fastest, sign * now[axis.ordinal()], last.speedMps(), last.rates().z());
  }

  private static boolean areEqual(double[] swings) {
    double least = Arrays.stream(swings).min().orElseThrow();
    return Arrays.stream(swings).max().orElseThrow() < EQUAL * least;
  }

  private boolean isSteady(double[] now, double drift, double turn) {
    double[] none = new double[now.length];
    double rate = length(now, none, MotionAxis.ROLL);
    return axis.isRotation()
        ? turn <= STEADY * rate
        : drift <= STEADY * length(now, none, MotionAxis.SURGE)
            && turn <= STEADY * rate + CALM_RADPS;
  }

  private static boolean isOver(Attitude attitude) {
    return Math.max(Math.abs(attitude.phi()), Math.abs(attitude.theta())) > OVERTURNED_RAD;
  }

  /** Length of the difference in three axes. */
  private static double length(double[] a, double[] b, MotionAxis first) {
    double sum = 0.0;
    for (int k = first.ordinal(); k < first.ordinal() + 3; k++) {
      sum += (a[k] - b[k]) * (a[k] - b[k]);
    }
    return Math.sqrt(sum);
  }
}
