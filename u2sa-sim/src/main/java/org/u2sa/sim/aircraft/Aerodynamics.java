package org.u2sa.sim.aircraft;

import static org.u2sa.sim.aircraft.Airframe.CHORD_M;
import static org.u2sa.sim.aircraft.Airframe.SPAN_M;
import static org.u2sa.sim.aircraft.Airframe.WING_AREA_M2;

/**
 * Aerodynamic forces and moments of the Cessna 172, power effects excluded.
 *
 * <p>Stability and control derivatives: Roskam, Airplane Flight Dynamics and Automatic Flight
 * Controls, part I, appendix B, airplane A (four-seat light aircraft), in the form documented for
 * the Cessna 172 by Peden (LaRCsim data of FlightGear 0.7, 1999): stability axes, per radian,
 * rudder sign reversed so that positive yaws right. Drag: Loftin, Quest for Performance, NASA
 * SP-468, table of the Cessna Skyhawk: zero-lift drag 0.0319, best lift-to-drag ratio 11.6. Stall:
 * sigmoid blend into a flat plate, Beard and McLain, Small Unmanned Aircraft, eq. 4.9, placed to
 * match the handbook's stall speeds (172P: 51 KCAS flaps up, 46 KCAS flaps 30°); the plate's normal
 * force is 2 sin α, because their eq. 4.10 (2 sin² α) removes more lift than such wings lose.
 * Ground effect: McCormick, Aerodynamics, Aeronautics, and Flight Mechanics, eq. 5.86. Spanwise
 * flow produces no lift: wing and tailplane use only the flow in the plane of symmetry (R. T.
 * Jones, NACA Report 863, 1947), which matters for an aircraft parked across the wind.
 */
final class Aerodynamics {
  private static final double CL_0 =
      0.31; // body axes are aligned with the flow in Roskam's cruise condition
  private static final double CL_ALPHA = 4.6;
  private static final double CL_Q = 3.9;
  private static final double CL_ELEVATOR = 0.43;
  private static final double CD_0 = 0.0319;
  private static final double CD_INDUCED = 0.0582; // 1 / (4 · 11.6² · 0.0319)
  private static final double CD_SIDESLIP = 0.17;
  private static final double CM_ALPHA = -0.89;
  private static final double CM_ALPHA_RATE = -5.2;
  private static final double CM_Q = -12.4;
  private static final double CM_ELEVATOR = -1.28;
  private static final double CY_BETA = -0.31;
  private static final double CY_P = -0.037;
  private static final double CY_R = 0.21;
  private static final double CY_RUDDER = -0.187;
  private static final double CR_BETA = -0.089; // rolling moment, l in the literature
  private static final double CR_P = -0.47;
  private static final double CR_R = 0.096; // at CL 0.31
  private static final double CR_AILERON = 0.178;
  private static final double CR_RUDDER = -0.0147;
  private static final double CN_BETA = 0.065;
  private static final double CN_P = -0.030;
  private static final double CN_R = -0.099;
  private static final double CN_AILERON = -0.053;
  private static final double CN_RUDDER = 0.0657;

  private static final double STALL_RAD = Math.toRadians(17.8); // midpoint of the stall
  private static final double BREAK_SHARPNESS = 50.0; // Beard and McLain, table E.2
  private static final double PLATE_NORMAL = 2.0; // normal force of the separated wing, per sine
  private static final double STALL_NOSE_DROP = -0.10; // the wing's centre of pressure moves aft
  private static final double AUTOROTATION = 0.10; // roll damping beyond the stall …
  private static final double ROLL_DAMPING_2 =
      -1.5; // … and is limited by a term quadratic in roll rate

  /**
   * Flaps 0…30°: lift increment at constant angle of attack, chosen to give 46 KCAS; drag and
   * moment from McCormick, chapters 3 and 4.
   */
  private static final Table FLAP_LIFT =
      new Table(0.0, 0.0, 1.0 / 3, 0.15, 2.0 / 3, 0.25, 1.0, 0.30);

  private static final Table FLAP_DRAG =
      new Table(0.0, 0.0, 1.0 / 3, 0.007, 2.0 / 3, 0.022, 1.0, 0.045);
  private static final Table FLAP_MOMENT =
      new Table(0.0, 0.0, 1.0 / 3, -0.020, 2.0 / 3, -0.030, 1.0, -0.035);

  /**
   * Ground-adjustable tabs: straight hands-off flight at 75 % power and 1800 Pa, offsetting the
   * left-turning tendency of slipstream and torque.
   */
  private static final double CR_RIGGING = 0.00099;

  private static final double CN_RIGGING = 0.00031;
  private static final double WING_ABOVE_CG_M = 0.9;

  // body forces [N], moments [N m], and pitching moment per angle-of-attack rate [N m s]
  double forceX;
  double forceY;
  double forceZ;
  double momentX;
  double momentY;
  double momentZ;
  double alphaRateMoment;

  private double flapLift;
  private double flapDrag;
  private double flapMoment;
  private double aileron;
  private double elevator;
  private double rudder;

  /** Sets the surface deflections for the next step. */
  void set(ControlInputs inputs, double flapPosition) {
    flapLift = FLAP_LIFT.at(flapPosition);
    flapDrag = FLAP_DRAG.at(flapPosition);
    flapMoment = FLAP_MOMENT.at(flapPosition);
    double stick = inputs.elevator(); // positive: trailing edge down
    elevator = stick * (stick < 0.0 ? Airframe.ELEVATOR_UP_RAD : Airframe.ELEVATOR_DOWN_RAD);
    aileron = inputs.aileron() * Airframe.AILERON_RAD;
    rudder = inputs.rudder() * Airframe.RUDDER_RAD;
  }

  /**
   * @param u velocity through the air, body axes [m/s]
   * @param p roll rate relative to the air [rad/s]
   * @param slipstreamPa dynamic pressure that the propeller adds at the tail
   * @param heightM height of the centre of gravity above ground
   */
  void compute(
      double u,
      double v,
      double w,
      double p,
      double q,
      double r,
      double density,
      double slipstreamPa,
      double heightM) {
    double plane2 = u * u + w * w;
    double plane = StrictMath.sqrt(plane2);
    double speed2 = plane2 + v * v;
    double speed = StrictMath.sqrt(speed2);
    if (speed < 0.01) {
      forceX = forceY = forceZ = momentX = momentY = momentZ = alphaRateMoment = 0.0;
      if (slipstreamPa <= 0.0) {
        return;
      }
    }
    double perSpeed = speed < 0.01 ? 0.0 : 1.0 / speed;
    double sinAlpha = plane < 0.01 ? 0.0 : w / plane;
    double cosAlpha = plane < 0.01 ? 1.0 : u / plane;
    double sinBeta = v * perSpeed;
    double alpha = plane < 0.01 ? 0.0 : StrictMath.atan2(w, u);
    double qs = 0.5 * density * speed2 * WING_AREA_M2; // of the total flow: fuselage and fin
    double qsWing = 0.5 * density * plane2 * WING_AREA_M2; // of the chordwise flow
    double tail = qsWing + slipstreamPa * WING_AREA_M2;
    double fin = qs + slipstreamPa * WING_AREA_M2;
    double rate = 0.25 * density * speed * WING_AREA_M2; // q S / (2 V)

    double roll = p * cosAlpha + r * sinAlpha; // stability axes: x along the flow
    double yaw = r * cosAlpha - p * sinAlpha;

    double stall = stallFraction(alpha);
    double attached = CL_0 + CL_ALPHA * alpha + flapLift;
    double plate = PLATE_NORMAL * sinAlpha * cosAlpha;
    double wingLift = (1.0 - stall) * attached + stall * plate;
    double ground = groundFactor(heightM);
    double attachedDrag = CD_0 + flapDrag + CD_INDUCED * ground * attached * attached;
    double plateDrag = CD_0 + flapDrag + PLATE_NORMAL * sinAlpha * sinAlpha;
    double wingDrag = (1.0 - stall) * attachedDrag + stall * plateDrag;

    double lift = qsWing * wingLift + tail * CL_ELEVATOR * elevator + rate * CHORD_M * CL_Q * q;
    double drag = qsWing * wingDrag + qs * CD_SIDESLIP * sinBeta * sinBeta;
    double side =
        qs * CY_BETA * sinBeta
            + fin * CY_RUDDER * rudder
            + rate * SPAN_M * (CY_P * roll + CY_R * yaw);
    forceX = lift * sinAlpha - drag * u * perSpeed;
    forceY = side; // this derivative includes the lateral component of drag
    forceZ = -lift * cosAlpha - drag * w * perSpeed;

    double liftBounded = Math.min(1.6, Math.max(0.0, wingLift));
    // Yaw rate speeds up one wing, so the rolling moment grows with lift (Etkin, Dynamics of
    // Flight, section 5.8); the fin's contribution is constant.
    double rollOfYaw = CR_R * (0.75 + 0.25 * liftBounded / CL_0);
    double rollDamping = (1.0 - stall) * CR_P + stall * AUTOROTATION;
    double helix = roll * SPAN_M * 0.5 * perSpeed;
    double rolling =
        qs * CR_BETA * sinBeta
            + qsWing
                * (CR_RIGGING
                    + CR_AILERON * aileron * (1.0 - 0.5 * stall)
                    + ROLL_DAMPING_2 * stall * helix * Math.abs(helix))
            + fin * CR_RUDDER * rudder
            + rate * SPAN_M * (rollDamping * roll + rollOfYaw * yaw);
    double pitching =
        qsWing
                * (CM_ALPHA * sinAlpha
                    + flapMoment
                    + STALL_NOSE_DROP * stall * Math.signum(sinAlpha))
            + tail * CM_ELEVATOR * elevator
            + rate * CHORD_M * CM_Q * q;
    double yawing =
        qs * CN_BETA * sinBeta
            + qsWing * (CN_RIGGING + CN_AILERON * aileron)
            + fin * CN_RUDDER * rudder
            + rate * SPAN_M * (CN_P * roll + CN_R * yaw);
    momentX = (rolling * cosAlpha - yawing * sinAlpha) * SPAN_M;
    momentY = pitching * CHORD_M;
    momentZ = (rolling * sinAlpha + yawing * cosAlpha) * SPAN_M;
    alphaRateMoment = rate * CHORD_M * CHORD_M * CM_ALPHA_RATE;
  }

  /** Degree of stall, 0 (attached) … 1 (fully separated). */
  static double stallFraction(double alpha) {
    double up = StrictMath.exp(-BREAK_SHARPNESS * (alpha - STALL_RAD));
    double down = StrictMath.exp(BREAK_SHARPNESS * (alpha + STALL_RAD));
    return Math.min(1.0, (1.0 + up + down) / ((1.0 + up) * (1.0 + down)));
  }

  private static double groundFactor(double heightM) {
    double ratio = 16.0 * Math.max(0.0, heightM + WING_ABOVE_CG_M) / SPAN_M;
    return ratio * ratio / (1.0 + ratio * ratio);
  }
}
