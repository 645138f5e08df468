package org.u2sa.sim.aircraft;

import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.gear.Wheel;
import org.u2sa.sim.motion.BodyAttitude;
import org.u2sa.sim.motion.RungeKutta;

/**
 * Rigid-body equations of motion over the WGS-84 ellipsoid: state vector in, derivative out.
 * Velocity is in NED; the local vertical rotates with position (transport rate); earth rotation is
 * neglected (0.02 % of g at these speeds).
 */
final class FlightDynamics implements RungeKutta.Motion {
  static final int LON = 0; // [rad]
  static final int LAT = 1; // [rad]
  static final int ALT = 2; // [m]
  static final int VN = 3;
  static final int VE = 4;
  static final int VD = 5;
  static final int Q0 = 6; // quaternion body → NED, scalar first
  static final int P = 10;
  static final int Q = 11;
  static final int R = 12;
  static final int SHAFT = 13; // engine speed [rad/s]
  static final int TYRES = 14; // tyre deflection along and across, three wheels [m]
  static final int SIZE = TYRES + 2 * LandingGear.WHEELS;

  static final double WGS84_A_M = 6_378_137.0;
  static final double WGS84_E2 = 6.69437999014e-3;

  private static final double SLIPSTREAM_SHARE =
      0.25; // fraction of the tail in the slipstream, times its contraction
  private static final double SWIRL_ARM =
      0.3; // yawing moment of the slipstream swirl on the fin, per shaft torque
  private static final double P_FACTOR =
      0.25; // P-factor: lateral thrust offset as a fraction of the radius, per sine of angle of
  // attack
  private static final double SLOWEST2 =
      100.0; // angle-of-attack rate is ignored below 10 m/s [m²/s²]

  private final double massKg;
  private final double ixx;
  private final double iyy;
  private final double izz;
  final Aerodynamics aero = new Aerodynamics();
  final Propeller propeller = new Propeller();
  final PistonEngine engine;
  final LandingGear gear = new LandingGear();
  final BodyAttitude attitude = new BodyAttitude();

  // environment during one step
  double densityKgPerM3 = StandardAtmosphere.SEA_LEVEL_DENSITY_KG_PER_M3;
  double windN;
  double windE;
  double windD;
  double gustP;
  double gustQ;
  double gustR;
  double groundM; // at the place of the slope

  private double slopeNorth; // of the ground there, uphill positive [1]
  private double slopeEast;
  private double slopeLatRad; // that place
  private double slopeLonRad;
  private double eastPerRad; // of longitude there [m/rad]

  // by-products of the last derivatives()
  double airU;
  double airV;
  double airW;
  double loadFactor = 1.0;

  FlightDynamics(PistonEngine engine) {
    this(engine, Airframe.MASS_KG, Point.of(Airframe.IXX, Airframe.IYY, Airframe.IZZ));
  }

  /**
   * @param massKg mass [kg]
   * @param inertia moments of inertia in roll, pitch and yaw [kg m²]
   */
  FlightDynamics(PistonEngine engine, double massKg, Point inertia) {
    this.engine = engine;
    this.massKg = massKg;
    ixx = inertia.x();
    iyy = inertia.y();
    izz = inertia.z();
  }

  /**
   * Sets the slope of the ground, uphill positive [1], at a place [rad]. The ground is level around
   * the aircraft, at the height of the slope under it: it rises and falls as the aircraft moves.
   */
  void slope(double north, double east, double latitudeRad, double longitudeRad) {
    slopeNorth = north;
    slopeEast = east;
    slopeLatRad = latitudeRad;
    slopeLonRad = longitudeRad;
    eastPerRad = WGS84_A_M * StrictMath.cos(latitudeRad);
  }

  /** Height of the ground above that at the place of the slope, within metres of it [m]. */
  private double riseM(double[] s) {
    return slopeNorth * WGS84_A_M * (s[LAT] - slopeLatRad)
        + slopeEast * eastPerRad * (s[LON] - slopeLonRad);
  }

  @Override
  public void derivatives(double[] s, double[] rate) {
    attitude.set(s[Q0], s[Q0 + 1], s[Q0 + 2], s[Q0 + 3]);
    double an = s[VN] - windN;
    double ae = s[VE] - windE;
    double ad = s[VD] - windD;
    airU = attitude.forward(an, ae, ad);
    airV = attitude.right(an, ae, ad);
    airW = attitude.below(an, ae, ad);
    double p = s[P];
    double q = s[Q];
    double r = s[R];
    double shaft = Math.max(0.0, s[SHAFT]);
    double height = s[ALT] - (groundM + riseM(s));
    double riseMps = slopeNorth * s[VN] + slopeEast * s[VE];

    propeller.compute(shaft, airU, densityKgPerM3);
    double thrust = propeller.thrustN();
    double engineTorque = engine.torqueNm(shaft);
    double wash = SLIPSTREAM_SHARE * Math.max(0.0, thrust) / Propeller.DISC_M2;
    aero.compute(airU, airV, airW, p - gustP, q - gustQ, r - gustR, densityKgPerM3, wash, height);

    double speed2 = airU * airU + airV * airV + airW * airW;
    double sinAlpha = airW / StrictMath.sqrt(Math.max(1.0, speed2));
    double fx = aero.forceX + thrust;
    double fy = aero.forceY;
    double fz = aero.forceZ;
    double spin =
        shaft * Propeller.INERTIA_KG_M2; // clockwise seen from the cockpit: along the forward axis
    double mx = aero.momentX - engineTorque;
    double my = aero.momentY - spin * r;
    double mz =
        aero.momentZ
            + spin * q
            - SWIRL_ARM * propeller.torqueNm()
            - P_FACTOR * Math.max(0.0, thrust) * sinAlpha * Propeller.DIAMETER_M / 2.0;

    double gn = 0.0;
    double ge = 0.0;
    double gd = 0.0;
    for (int i = 0; i < LandingGear.WHEELS; i++) {
      Wheel wheel = gear.wheels[i];
      int tyre = TYRES + 2 * i;
      double wheelHeight = height - attitude.down(wheel.x(), wheel.y(), wheel.z());
      double vx = q * wheel.z() - r * wheel.y();
      double vy = r * wheel.x() - p * wheel.z();
      double vz = p * wheel.y() - q * wheel.x();
      wheel.compute(
          attitude,
          wheelHeight,
          s[VN] + attitude.north(vx, vy, vz),
          s[VE] + attitude.east(vx, vy, vz),
          s[VD] + attitude.down(vx, vy, vz) + riseMps,
          s[tyre],
          s[tyre + 1]);
      rate[tyre] = wheel.deflectionAlongRate();
      rate[tyre + 1] = wheel.deflectionAcrossRate(s[tyre + 1]);
      if (wheel.compressionM() > 0.0) {
        double bx = attitude.forward(wheel.forceN(), wheel.forceE(), wheel.forceD());
        double by = attitude.right(wheel.forceN(), wheel.forceE(), wheel.forceD());
        double bz = attitude.below(wheel.forceN(), wheel.forceE(), wheel.forceD());
        mx += wheel.y() * bz - wheel.z() * by;
        my += wheel.z() * bx - wheel.x() * bz;
        mz += wheel.x() * by - wheel.y() * bx;
        gn += wheel.forceN();
        ge += wheel.forceE();
        gd += wheel.forceD();
      }
    }

    double forceN = gn + attitude.north(fx, fy, fz);
    double forceE = ge + attitude.east(fx, fy, fz);
    double forceD = gd + attitude.down(fx, fy, fz);
    double accN = forceN / massKg;
    double accE = forceE / massKg;
    double accD = forceD / massKg;
    loadFactor = -attitude.below(accN, accE, accD) / Gravity.STANDARD_MPS2;
    accD += Gravity.STANDARD_MPS2;

    // α' = (w'u − u'w)/(u² + w²), body accelerations with u' = a − ω × v (Stevens and Lewis, 2nd
    // ed., eq. 1.4)
    double uDot = attitude.forward(accN, accE, accD) + r * airV - q * airW;
    double wDot = attitude.below(accN, accE, accD) + q * airU - p * airV;
    double alphaRate = (wDot * airU - uDot * airW) / Math.max(SLOWEST2, airU * airU + airW * airW);
    my += aero.alphaRateMoment * alphaRate;

    double sinLat = StrictMath.sin(s[LAT]);
    double cosLat = Math.max(1e-6, StrictMath.sqrt(1.0 - sinLat * sinLat));
    double w2 = 1.0 - WGS84_E2 * sinLat * sinLat;
    double prime = WGS84_A_M / StrictMath.sqrt(w2); // radius of curvature in the prime vertical
    double meridian = prime * (1.0 - WGS84_E2) / w2;
    double turnN = s[VE] / (prime + s[ALT]); // transport rate
    double turnE = -s[VN] / (meridian + s[ALT]);
    double turnD = -turnN * sinLat / cosLat;
    rate[LAT] = -turnE;
    rate[LON] = turnN / cosLat;
    rate[ALT] = -s[VD];
    rate[VN] = accN - (turnE * s[VD] - turnD * s[VE]);
    rate[VE] = accE - (turnD * s[VN] - turnN * s[VD]);
    rate[VD] = accD - (turnN * s[VE] - turnE * s[VN]);

    double wx = p - attitude.forward(turnN, turnE, turnD);
    double wy = q - attitude.right(turnN, turnE, turnD);
    double wz = r - attitude.below(turnN, turnE, turnD);
    double q0 = s[Q0];
    double q1 = s[Q0 + 1];
    double q2 = s[Q0 + 2];
    double q3 = s[Q0 + 3];
    rate[Q0] = 0.5 * (-q1 * wx - q2 * wy - q3 * wz);
    rate[Q0 + 1] = 0.5 * (q0 * wx + q2 * wz - q3 * wy);
    rate[Q0 + 2] = 0.5 * (q0 * wy + q3 * wx - q1 * wz);
    rate[Q0 + 3] = 0.5 * (q0 * wz + q1 * wy - q2 * wx);

    rate[P] = (mx + (iyy - izz) * q * r) / ixx;
    rate[Q] = (my + (izz - ixx) * p * r) / iyy;
    rate[R] = (mz + (ixx - iyy) * p * q) / izz;
    rate[SHAFT] = (engineTorque - propeller.torqueNm()) / Propeller.INERTIA_KG_M2;
  }
}
