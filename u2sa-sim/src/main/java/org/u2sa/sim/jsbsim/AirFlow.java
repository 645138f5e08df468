package org.u2sa.sim.jsbsim;

import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.flight.Air;
import org.u2sa.sim.vehicle.BodyState;

/** Airflow at an aircraft and the properties that describe it. Not thread-safe. */
final class AirFlow {
  private static final double SLUG_PER_FT3 = 1.0 / 515.378818; // of kg/m³
  private static final double PSF_PER_PA = 0.020885434;
  private static final double RANKINE_PER_K = 1.8;
  private static final double KNOT_MPS = 1852.0 / 3600.0;
  private static final double SUTHERLAND_K = 110.4; // of air's viscosity: ICAO Doc 7488/3
  private static final double SUTHERLAND_BETA = 1.458e-6; // [kg/(m s K^½)]

  private final PropertyTree properties;
  private final double area;
  private final double span;
  private final double chord;
  private final double[] reference; // reference point of the aerodynamic moments, structural [ft]
  private double alphaRate;
  private double betaRate;

  // axes: forward, right, down; [ft/s], [rad/s]
  double u;
  double v;
  double w;
  double p;
  double q;
  double r;
  double speed;
  double alpha;
  double beta;
  double density; // [slug/ft³]
  double soundSpeed; // [ft/s]
  double pressurePa;
  double totalPressurePa;
  double temperatureK;
  double dynamicPressure; // [lb/ft²]

  AirFlow(PropertyTree properties, XmlElement metrics) {
    this.properties = properties;
    metrics.refuseUnknownChildren(
        ("wingarea wingspan chord wing_incidence htailarea htailarm vtailarea vtailarm "
                + "location description documentation")
            .split(" "));
    area = UnitNumbers.number(metrics, "wingarea", "FT2");
    span = UnitNumbers.number(metrics, "wingspan", UnitNumbers.FT);
    chord = UnitNumbers.number(metrics, "chord", UnitNumbers.FT);
    reference =
        metrics.children("location").stream()
            .filter(each -> each.attribute("name").equals("AERORP"))
            .findFirst()
            .map(UnitNumbers::place)
            .orElseThrow(() -> metrics.error("lacks <location name=\"AERORP\">"));
    properties.set("metrics/Sw-sqft", area);
    properties.set("metrics/bw-ft", span);
    properties.set("metrics/cbarw-ft", chord);
    properties.set("metrics/iw-rad", UnitNumbers.number(metrics, "wing_incidence", "RAD", 0.0));
    for (String each : new String[] {"h", "v"}) {
      double size = UnitNumbers.number(metrics, each + "tailarea", "FT2", 0.0);
      double arm = UnitNumbers.number(metrics, each + "tailarm", UnitNumbers.FT, 0.0);
      properties.set("metrics/S" + each + "-sqft", size);
      properties.set("metrics/l" + each + "-ft", arm);
    }
    update(new double[BodyState.SIZE], new Air(), reference);
  }

  double spanM() {
    return span * UnitNumbers.M_PER_FT;
  }

  double area() {
    return area;
  }

  double[] reference() {
    return reference;
  }

  /**
   * Stores the accelerations of the last tick, from which the angles' rates follow.
   *
   * @param rate derivative of the state
   */
  void accelerate(double[] rate) {
    double square = u * u + w * w;
    if (!(square > 1.0)) {
      alphaRate = 0.0;
      betaRate = 0.0;
      return;
    }
    double du = rate[BodyState.VELOCITY] / UnitNumbers.M_PER_FT;
    double dv = rate[BodyState.VELOCITY + 1] / UnitNumbers.M_PER_FT;
    double dw = rate[BodyState.VELOCITY + 2] / UnitNumbers.M_PER_FT;
    double ds = (u * du + v * dv + w * dw) / speed;
    alphaRate = (u * dw - w * du) / square;
    betaRate = (dv * speed - v * ds) / (speed * StrictMath.sqrt(square));
  }

  /**
   * Computes the flow.
   *
   * @param s state of the aircraft
   * @param centre centre of gravity, structural [ft]
   */
  void update(double[] s, Air air, double[] centre) {
    StandardAtmosphere.Air standard = air.standard();
    u = air.u() / UnitNumbers.M_PER_FT;
    v = air.v() / UnitNumbers.M_PER_FT;
    w = air.w() / UnitNumbers.M_PER_FT;
    p = s[BodyState.RATES] - air.gustP();
    q = s[BodyState.RATES + 1] - air.gustQ();
    r = s[BodyState.RATES + 2] - air.gustR();
    double flat = StrictMath.sqrt(u * u + w * w);
    speed = StrictMath.sqrt(u * u + v * v + w * w);
    alpha = flat > 1e-3 ? StrictMath.atan2(w, u) : 0.0;
    beta = speed > 1e-3 ? StrictMath.atan2(v, flat) : 0.0;
    density = standard.densityKgPerM3() * SLUG_PER_FT3;
    soundSpeed = standard.soundSpeedMps() / UnitNumbers.M_PER_FT;
    temperatureK = standard.temperatureK();
    pressurePa = standard.pressurePa();
    double mach = speed / soundSpeed;
    totalPressurePa = pressurePa * StrictMath.pow(1.0 + 0.2 * mach * mach, 3.5);
    dynamicPressure = 0.5 * density * speed * speed;
    double q0 = s[BodyState.QUATERNION];
    double q1 = s[BodyState.QUATERNION + 1];
    double q2 = s[BodyState.QUATERNION + 2];
    double q3 = s[BodyState.QUATERNION + 3];
    double below = // reference point below the centre of gravity [ft]
        2.0 * (q1 * q3 - q0 * q2) * (centre[0] - reference[0])
            + (1.0 - 2.0 * (q1 * q1 + q2 * q2)) * (centre[2] - reference[2]);
    publish(mach, flat, standard);
    double height = air.heightM() / UnitNumbers.M_PER_FT;
    properties.set("position/h-agl-ft", height);
    properties.set("aero/h_b-cg-ft", height / span);
    properties.set("aero/h_b-mac-ft", (height - below) / span);
    properties.set("velocities/p-rad_sec", s[BodyState.RATES]);
    properties.set("velocities/q-rad_sec", s[BodyState.RATES + 1]);
    properties.set("velocities/r-rad_sec", s[BodyState.RATES + 2]);
  }

  private void publish(double mach, double flat, StandardAtmosphere.Air standard) {
    properties.set("aero/alpha-rad", alpha);
    properties.set("aero/alpha-deg", StrictMath.toDegrees(alpha));
    properties.set("aero/mag-alpha-rad", Math.abs(alpha));
    properties.set("aero/beta-rad", beta);
    properties.set("aero/beta-deg", StrictMath.toDegrees(beta));
    properties.set("aero/mag-beta-rad", Math.abs(beta));
    properties.set("aero/alphadot-rad_sec", alphaRate);
    properties.set("aero/betadot-rad_sec", betaRate);
    properties.set("aero/qbar-psf", dynamicPressure);
    properties.set("aero/qbarUW-psf", 0.5 * density * flat * flat);
    properties.set("aero/qbarUV-psf", 0.5 * density * (u * u + v * v));
    properties.set("aero/qbar-area", dynamicPressure * area);
    double twice = 2.0 * Math.max(1e-3, speed);
    properties.set("aero/bi2vel", span / twice);
    properties.set("aero/ci2vel", chord / twice);
    properties.set("aero/Re", reynolds(standard));
    properties.set("velocities/u-aero-fps", u);
    properties.set("velocities/v-aero-fps", v);
    properties.set("velocities/w-aero-fps", w);
    properties.set("velocities/p-aero-rad_sec", p);
    properties.set("velocities/q-aero-rad_sec", q);
    properties.set("velocities/r-aero-rad_sec", r);
    properties.set("velocities/vt-fps", speed);
    properties.set("velocities/mach", mach);
    double speedMps = speed * UnitNumbers.M_PER_FT;
    properties.set("velocities/vc-kts", standard.calibratedAirspeedMps(speedMps) / KNOT_MPS);
    properties.set("atmosphere/rho-slugs_ft3", density);
    properties.set("atmosphere/P-psf", pressurePa * PSF_PER_PA);
    properties.set("atmosphere/T-R", temperatureK * RANKINE_PER_K);
    properties.set("atmosphere/a-fps", soundSpeed);
  }

  private double reynolds(StandardAtmosphere.Air standard) {
    double viscosity =
        SUTHERLAND_BETA * StrictMath.pow(temperatureK, 1.5) / (temperatureK + SUTHERLAND_K);
    double metres = speed * chord * UnitNumbers.M_PER_FT * UnitNumbers.M_PER_FT;
    return metres * standard.densityKgPerM3() / viscosity;
  }
}
