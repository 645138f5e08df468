package org.u2sa.sim.aircraft;

/**
 * Lycoming O-320-D2J: 160 hp at 2700 rpm (type certificate data sheet E-274). Power over density
 * from Gagg and Ferrar (1.132 σ − 0.132, SAE Transactions 1934), which splits brake torque into
 * indicated torque, proportional to the charge, and constant friction; the throttle is an orifice
 * ahead of the cylinders, so the charge falls with engine speed.
 */
final class PistonEngine {
  static final double RADPERS_PER_RPM = 2.0 * Math.PI / 60.0;
  static final double IDLE_RPM = 650.0;

  private static final double MAX_RPM = 2_700.0;
  private static final double RATED_TORQUE_NM =
      160.0 * 745.6999 / (MAX_RPM * RADPERS_PER_RPM); // 422 N m
  private static final double INDICATED = 1.132;
  private static final double FRICTION = 0.132;
  private static final double IDLE_OPENING = 0.0505; // idles at 650 rpm, static, at sea level
  private static final double FULL_OPENING = 5.0;
  private static final double STALL_RPM = 350.0;
  private static final double LIGHT_RPM = 450.0; // windmilling at this speed restarts it

  /**
   * Full-throttle torque over rpm, relative to rated torque, from the manufacturer's sea-level
   * power curve.
   */
  private static final Table FULL_THROTTLE =
      new Table(
          0.0, 0.82, 650.0, 0.92, 1_500.0, 1.02, 2_000.0, 1.045, 2_400.0, 1.045, 2_700.0, 1.02,
          3_000.0, 0.95, 3_500.0, 0.70);

  /**
   * Power over fuel-air equivalence ratio: Taylor, The Internal-Combustion Engine, volume 1, figure
   * 12-6.
   */
  private static final Table MIXTURE =
      new Table(
          0.50, 0.0, 0.60, 0.55, 0.70, 0.75, 0.80, 0.88, 0.90, 0.96, 1.00, 0.99, 1.10, 1.0, 1.25,
          1.0, 1.40, 0.95, 1.60, 0.83, 1.80, 0.60, 2.10, 0.0);

  private static final double RICH_AT_SEA_LEVEL = 1.2;

  private boolean running;
  private double opening = IDLE_OPENING;
  private double mixtureFactor = 1.0;
  private double densityRatio = 1.0;

  PistonEngine(boolean running) {
    this.running = running;
  }

  /** Sets levers and air for the next step, and starts or stops the engine. */
  void set(double throttle, double mixture, double newDensityRatio, double speedRadPerS) {
    densityRatio = newDensityRatio;
    opening = IDLE_OPENING * StrictMath.pow(FULL_OPENING / IDLE_OPENING, throttle);
    // A float carburettor meters by pressure difference, so the mixture richens with the inverse
    // root of air density.
    mixtureFactor = MIXTURE.at(RICH_AT_SEA_LEVEL * mixture / StrictMath.sqrt(newDensityRatio));
    double rpm = speedRadPerS / RADPERS_PER_RPM;
    if (rpm < STALL_RPM) {
      running = false;
    } else if (rpm > LIGHT_RPM) {
      running = true;
    }
  }

  /** Brake torque [N m] at a shaft speed [rad/s], at least 0. */
  double torqueNm(double speedRadPerS) {
    if (!running) {
      return -FRICTION * RATED_TORQUE_NM * Math.min(1.0, Math.max(0.0, speedRadPerS));
    }
    double rpm = speedRadPerS / RADPERS_PER_RPM;
    double choke = rpm / (MAX_RPM * opening);
    double charge = densityRatio / StrictMath.sqrt(1.0 + choke * choke);
    double indicated = INDICATED * charge * FULL_THROTTLE.at(rpm) * mixtureFactor;
    return RATED_TORQUE_NM * (indicated - FRICTION);
  }

  boolean running() {
    return running;
  }

  void start() {
    running = true;
  }

  void stop() {
    running = false;
  }
}
