package org.u2sa.sim.jsbsim;

import org.u2sa.interfaces.xml.XmlElement;

/**
 * A normally aspirated piston engine as JSBSim models it: manifold pressure from the impedances of
 * throttle, intake and cylinders, air and fuel flow from it, and power from fuel flow, mixture and
 * friction (Taylor, The Internal-Combustion Engine, volume 1, eq. 6-10 for the charge).
 */
final class PistonPower {
  private static final double STANDARD_PA = 101_320.73;
  private static final double GAS_CONSTANT = 287.3;
  private static final double LB_PER_KG = 2.2046;
  private static final double HEAT_RATIO = 1.3; // mass of the charge
  private static final double STOICHIOMETRIC = 14.7;
  private static final double RICHEST = 1.3; // equivalence ratio at full mixture, sea level
  private static final double M3_PER_IN3 = 1.6387064e-5;
  private static final double PUMPING_W_MIN_PER_HP = 22_371.0; // ½ · 60 s/min · 745.7 W/hp
  private static final double STALLS_AT_IDLE = 0.8; // fraction of the idling speed
  private static final double RUNS_ABOVE_HP = 0.125; // below this indicated power it stops

  /** Efficiency over the ratio of fuel to air: JSBSim's default. */
  private static final double[][] MIXTURE = {
    {0.05, 0.0}, {0.05137, 0.00862}, {0.05179, 0.21552}, {0.0543, 0.48276}, {0.05842, 0.7069},
    {0.06312, 0.83621}, {0.06942, 0.93103}, {0.07786, 1.0}, {0.08845, 1.0}, {0.0927, 0.98276},
    {0.1012, 0.93103}, {0.11455, 0.72414}, {0.12158, 0.4569}, {0.12435, 0.23276}, {0.125, 0.0}
  };

  private final double displacementM3;
  private final double strokeIn;
  private final double cycles;
  private final double idleRpm;
  private final double staticFrictionHp;
  private final double lagS;
  private final double volumetricEfficiency;
  private final double compression;
  private final double ramFactor;
  private final double peakPistonFps;
  private final double dynamicFriction;
  private final double staticFrictionPa;
  private final double airboxImpedance;
  private final double throttleImpedance;
  private final double specificConsumption; // [lb/(hp h)]
  private double manifoldPa;
  private boolean isRunning = true;
  private double fuelLbPerS = 1e-6; // positive, so that the engine initially runs

  PistonPower(XmlElement file) {
    file.refuseUnknownChildren(
        ("minmp maxmp man-press-lag displacement maxhp static-friction sparkfaildrop "
                + "cycles idlerpm maxrpm maxthrottle minthrottle bsfc volumetric-efficiency "
                + "compression-ratio bore stroke cylinders cylinder-head-mass "
                + "air-intake-impedance-factor ram-air-factor cooling-factor starter-rpm "
                + "starter-torque dynamic-fmep static-fmep peak-piston-speed description "
                + "documentation")
            .split(" "));
    double minPa = UnitNumbers.number(file, "minmp", "INHG", 6.5) * 3_386.38;
    double maxInHg = UnitNumbers.number(file, "maxmp", "INHG", 28.5);
    double displacement = UnitNumbers.number(file, "displacement", "IN3", 360.0);
    double maxHp = UnitNumbers.number(file, "maxhp", "HP", 200.0);
    double maxRpm = pure(file, "maxrpm", 2_800.0);
    displacementM3 = displacement * M3_PER_IN3;
    lagS = pure(file, "man-press-lag", 1.0);
    staticFrictionHp = UnitNumbers.number(file, "static-friction", "HP", 1.5);
    cycles = pure(file, "cycles", 4.0);
    idleRpm = pure(file, "idlerpm", 600.0);
    volumetricEfficiency = pure(file, "volumetric-efficiency", 0.85);
    compression = pure(file, "compression-ratio", 8.5);
    strokeIn = UnitNumbers.number(file, "stroke", UnitNumbers.FT, 4.375 / 12.0) * 12.0;
    ramFactor = pure(file, "ram-air-factor", 1.0);
    peakPistonFps = pure(file, "peak-piston-speed", 100.0);
    dynamicFriction = UnitNumbers.number(file, "dynamic-fmep", "PA", 18_400.0);
    staticFrictionPa = UnitNumbers.number(file, "static-fmep", "PA", 46_500.0);
    double ratedFps = pistonFps(maxRpm);
    double lossPa =
        (29.92 - maxInHg) * 3_386.38 * volumetricEfficiency
            + dynamicFriction * ratedFps * UnitNumbers.M_PER_FT
            + staticFrictionPa;
    double lossHp = lossPa * displacementM3 * maxRpm / (cycles * PUMPING_W_MIN_PER_HP);
    double usual =
        1.1
            * displacement
            * maxRpm
            * volumetricEfficiency
            * (maxInHg / 29.92)
            / (9_411.0 * (maxHp + lossHp - staticFrictionHp));
    specificConsumption = UnitNumbers.number(file, "bsfc", "LBS/HP*HR", usual);
    double full = peakPistonFps / ratedFps;
    airboxImpedance =
        pure(
            file,
            "air-intake-impedance-factor",
            STANDARD_PA * full / (Math.min(maxInHg, 29.9) * 3_386.38) - full);
    throttleImpedance =
        peakPistonFps / pistonFps(idleRpm) * (STANDARD_PA / minPa - 1.0) - airboxImpedance;
    manifoldPa = STANDARD_PA;
  }

  private static double pure(XmlElement file, String name, double ifAbsent) {
    return UnitNumbers.number(file, name, UnitNumbers.PURE, ifAbsent);
  }

  private double pistonFps(double rpm) {
    return rpm * strokeIn / 360.0;
  }

  double idleRpm() {
    return idleRpm;
  }

  /** Fuel flow of the last {@link #powerHp} [lb/s]. */
  double fuelLbPerS() {
    return fuelLbPerS;
  }

  double manifoldPa() {
    return manifoldPa;
  }

  void fill(double newManifoldPa) {
    manifoldPa = newManifoldPa;
  }

  /**
   * Power at the shaft; negative while it is driven [hp].
   *
   * @param mixture 0…1
   * @param hasFuel whether a tank feeds it
   */
  double powerHp(
      AirFlow flow, double rpm, double throttle, double mixture, boolean hasFuel, double dtS) {
    isRunning =
        fuelLbPerS > 0.0
            && (isRunning ? rpm >= STALLS_AT_IDLE * idleRpm : rpm > STALLS_AT_IDLE * idleRpm);
    double pistonFps = pistonFps(rpm);
    breathe(flow, pistonFps, throttle, dtS);
    double charge = // loss by exhaust gas left in the cylinders
        (HEAT_RATIO - 1.0) / HEAT_RATIO
            + (compression - Math.min(compression, flow.pressurePa / Math.max(1.0, manifoldPa)))
                / (HEAT_RATIO * (compression - 1.0));
    double airM3PerS = displacementM3 * rpm / 60.0 / 2.0 * volumetricEfficiency * charge;
    double airKgPerS = airM3PerS * manifoldPa / (GAS_CONSTANT * flow.temperatureK);
    double ratio = hasFuel ? RICHEST * mixture * 101_325.0 / flow.pressurePa : 0.0;
    double fuelToAir = ratio / STOICHIOMETRIC;
    fuelLbPerS = airKgPerS * fuelToAir * LB_PER_KG;
    double indicated = -staticFrictionHp;
    double frictionPa = 0.0;
    if (isRunning) {
      frictionPa = -dynamicFriction * pistonFps * UnitNumbers.M_PER_FT - staticFrictionPa;
      indicated += fuelLbPerS * 3_600.0 / specificConsumption * efficiency(fuelToAir);
    }
    isRunning &= indicated >= RUNS_ABOVE_HP;
    double pumpingPa = (manifoldPa - flow.pressurePa) * volumetricEfficiency;
    double pumpingHp =
        (pumpingPa + frictionPa) * displacementM3 * rpm / (cycles * PUMPING_W_MIN_PER_HP);
    double power = indicated + pumpingHp;
    return rpm <= 0.1 ? Math.max(0.0, power) : power;
  }

  private void breathe(AirFlow flow, double pistonFps, double throttle, double dtS) {
    double ram = (flow.totalPressurePa - flow.pressurePa) * ramFactor + flow.pressurePa;
    double shut = 1.0 - throttle;
    double engine = pistonFps > 0.0 ? peakPistonFps / pistonFps : 999_999.0;
    double wanted = ram * engine / (engine + airboxImpedance + shut * shut * throttleImpedance);
    manifoldPa += (wanted - manifoldPa) * Math.min(1.0, dtS / Math.max(lagS, dtS));
  }

  private static double efficiency(double fuelToAir) {
    int i = 1;
    while (i < MIXTURE.length - 1 && MIXTURE[i][0] < fuelToAir) {
      i++;
    }
    double share = (fuelToAir - MIXTURE[i - 1][0]) / (MIXTURE[i][0] - MIXTURE[i - 1][0]);
    double bounded = Math.max(0.0, Math.min(1.0, share));
    return MIXTURE[i - 1][1] + bounded * (MIXTURE[i][1] - MIXTURE[i - 1][1]);
  }
}
