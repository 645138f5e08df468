package org.u2sa.sim.flight;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.sim.gear.Wheel;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.vehicle.BodyState;

/** A wing with control surfaces and a propeller, the last actuator. */
final class Wings implements AirLoads {
  private static final double LINEAR_RAD = 0.5;
  private static final double SLOWEST_MPS = 1.0; // below it, rates count as at this airspeed

  private final WingCoefficients wing;
  private final List<ControlSurface> surfaces;
  private final ElectricPropeller propeller;
  private final List<Wheel> wheels;
  private final List<String> names = new ArrayList<>();
  private final double[] target;
  private final double[] kept;

  /**
   * @param wheels wheels, of which the steered ones are linked to the rudder
   */
  Wings(
      WingCoefficients wing,
      List<ControlSurface> surfaces,
      ElectricPropeller propeller,
      List<Wheel> wheels) {
    this.wing = wing;
    this.wheels = List.copyOf(wheels);
    this.surfaces = List.copyOf(surfaces);
    this.propeller = propeller;
    surfaces.forEach(each -> names.add(each.name()));
    names.add(propeller.name());
    target = new double[names.size()];
    kept = new double[names.size()];
    Arrays.fill(kept, 1.0);
  }

  @Override
  public List<String> actuators() {
    return names;
  }

  @Override
  public void command(int actuator, double value) {
    boolean steers = actuator < surfaces.size();
    String what = "command of " + names.get(actuator);
    double told = Arguments.requireInside(what, value, steers ? -1.0 : 0.0, 1.0);
    target[actuator] = steers ? told * surfaces.get(actuator).travelRad() : told;
  }

  @Override
  public void weaken(int actuator, double share) {
    kept[actuator] = AirLoads.share(share);
  }

  @Override
  public boolean isDriven() {
    return target[surfaces.size()] > Catapult.RUNS_ABOVE;
  }

  @Override
  public double spanM() {
    return wing.spanM();
  }

  /** {@inheritDoc} Power of the propeller's motor; servos are neglected. */
  @Override
  public double powerW(double[] s, int first, Air air) {
    int last = surfaces.size();
    return propeller.powerW(kept[last] * s[first + last], air.speedMps(), air.densityKgPerM3);
  }

  @Override
  public void add(double[] s, double[] rate, int first, Air air, double[] load) {
    double elevator = 0.0;
    double aileron = 0.0;
    double rudder = 0.0;
    for (int i = 0; i < surfaces.size(); i++) {
      ControlSurface surface = surfaces.get(i);
      double deflection = s[first + i];
      rate[first + i] = (target[i] - deflection) / surface.timeConstantS();
      elevator += kept[i] * surface.elevator() * deflection;
      aileron += kept[i] * surface.aileron() * deflection;
      rudder += kept[i] * surface.rudder() * deflection;
    }
    for (Wheel wheel : wheels) {
      wheel.set(-rudder, 0.0); // a positive rudder yaws left
    }
    int last = surfaces.size();
    double throttle = s[first + last];
    rate[first + last] = (target[last] - throttle) / propeller.timeConstantS();
    aerodynamics(s, air, elevator, aileron, rudder, load);
    propulsion(kept[last] * throttle, air, load);
  }

  private void aerodynamics(
      double[] s, Air air, double elevator, double aileron, double rudder, double[] load) {
    double speed = air.speedMps();
    if (speed < 1e-6) {
      return;
    }
    double alpha = StrictMath.atan2(air.w, air.u);
    double beta = linear(StrictMath.asin(StrictMath.max(-1.0, StrictMath.min(1.0, air.v / speed))));
    double twice = 2.0 * StrictMath.max(SLOWEST_MPS, speed);
    double p = (s[BodyState.RATES] - air.gustP) * wing.spanM() / twice;
    double q = (s[BodyState.RATES + 1] - air.gustQ) * wing.chordM() / twice;
    double r = (s[BodyState.RATES + 2] - air.gustR) * wing.spanM() / twice;
    double pressure = 0.5 * air.densityKgPerM3 * speed * speed * wing.areaM2();
    double lift =
        pressure * (wing.liftAt(alpha) + wing.lift().q() * q + wing.lift().elevator() * elevator);
    double drag =
        pressure * (wing.dragAt(alpha) + wing.dragQ() * q + wing.dragElevator() * elevator);
    double sin = StrictMath.sin(alpha);
    double cos = StrictMath.cos(alpha);
    WingCoefficients.Longitudinal pitch = wing.pitch();
    load[0] += -drag * cos + lift * sin;
    load[1] += pressure * wing.side().at(beta, p, r, aileron, rudder);
    load[2] += -drag * sin - lift * cos;
    load[3] += pressure * wing.spanM() * wing.roll().at(beta, p, r, aileron, rudder);
    load[4] +=
        pressure
            * wing.chordM()
            * (pitch.zero()
                + pitch.alpha() * linear(alpha)
                + pitch.q() * q
                + pitch.elevator() * elevator);
    load[5] += pressure * wing.spanM() * wing.yaw().at(beta, p, r, aileron, rudder);
  }

  /**
   * The angle of which a linear derivative is a multiple: itself in flight, and beyond 0.5 rad, as
   * when parked in wind from behind or abeam, less, since moments and side force follow the sine
   * there.
   */
  static double linear(double angleRad) {
    return StrictMath.abs(angleRad) <= LINEAR_RAD
        ? angleRad
        : LINEAR_RAD
            * StrictMath.signum(angleRad)
            * StrictMath.min(
                1.0, StrictMath.abs(StrictMath.sin(angleRad) / StrictMath.sin(LINEAR_RAD)));
  }

  private void propulsion(double throttle, Air air, double[] load) {
    double speed = propeller.speedRadPerS(throttle, air.speedMps(), air.densityKgPerM3);
    load[0] += propeller.thrustN(speed, air.speedMps(), air.densityKgPerM3);
    load[3] -= propeller.torqueNm(speed, air.speedMps(), air.densityKgPerM3);
  }
}
