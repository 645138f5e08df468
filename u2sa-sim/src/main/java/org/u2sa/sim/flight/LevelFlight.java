package org.u2sa.sim.flight;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.atmosphere.StandardAtmosphere;

/**
 * Range of steady, level, trimmed flight at sea level: L + T sin α = m g and T cos α = D with a
 * pitch moment of 0, of lift L, drag D, thrust T and angle of attack α (Stevens &amp; Lewis, 2nd
 * ed., section 2.6).
 *
 * @param slowestMps lowest airspeed with a lift that still grows with the angle of attack
 * @param fastestMps highest airspeed
 */
public record LevelFlight(double slowestMps, double fastestMps) {
  private static final double DENSITY = StandardAtmosphere.SEA_LEVEL_DENSITY_KG_PER_M3;
  private static final double LOWEST_RAD = -0.3;
  private static final double STEP_RAD = 1e-4;

  /** Angle of attack with the most lift [rad]. */
  public static double stallRad(WingCoefficients wing) {
    double alpha = 0.0;
    while (wing.liftAt(alpha + STEP_RAD) > wing.liftAt(alpha)) {
      alpha += STEP_RAD;
    }
    return alpha;
  }

  /** The range; empty if thrust, lift or elevators do not suffice at any speed. */
  public static Optional<LevelFlight> of(
      double massKg,
      WingCoefficients wing,
      List<ControlSurface> surfaces,
      ElectricPropeller propeller) {
    double reach = // of the elevators
        surfaces.stream().mapToDouble(each -> Math.abs(each.elevator()) * each.travelRad()).sum();
    double slowest = Double.POSITIVE_INFINITY;
    double fastest = 0.0;
    double stall = stallRad(wing);
    for (double alpha = LOWEST_RAD; alpha <= stall; alpha += STEP_RAD) {
      double moment = wing.pitch().zero() + wing.pitch().alpha() * Wings.linear(alpha);
      double elevator = moment == 0.0 ? 0.0 : -moment / wing.pitch().elevator();
      if (!(Math.abs(elevator) <= reach)) {
        continue; // also without elevators
      }
      double lift = wing.liftAt(alpha) + wing.lift().elevator() * elevator;
      double drag = wing.dragAt(alpha) + wing.dragElevator() * elevator;
      double up = (lift + drag * Math.tan(alpha)) * 0.5 * DENSITY * wing.areaM2();
      double speed = Math.sqrt(massKg * Gravity.STANDARD_MPS2 / up); // NaN if it pushes down
      double thrust = drag * 0.5 * DENSITY * speed * speed * wing.areaM2() / Math.cos(alpha);
      double turns = propeller.speedRadPerS(1.0, speed, DENSITY);
      if (thrust <= propeller.thrustN(turns, speed, DENSITY)) {
        slowest = Math.min(slowest, speed);
        fastest = Math.max(fastest, speed);
      }
    }
    return fastest > 0.0 ? Optional.of(new LevelFlight(slowest, fastest)) : Optional.empty();
  }
}
