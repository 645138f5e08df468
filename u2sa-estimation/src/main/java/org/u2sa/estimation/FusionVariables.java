package org.u2sa.estimation;

import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.estimation.fusion.FilterTuning;
import org.u2sa.estimation.fusion.MotionDomain;
import org.u2sa.estimation.measurement.UsualSigmas;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/**
 * Variables of the fusing State Estimator. Where 0 selects the domain's value, that value is
 * recommended.
 */
record FusionVariables(
    @Variable(ifAbsentText = "GROUND")
        @Description("Domain in which the vehicle moves; sets the defaults of the motion model.")
        MotionDomain domain,
    @Variable(unit = "Hz", min = 0.1, max = 1000, ifAbsent = 50)
        @Description("Maximum rate of published states; each measurement may trigger one.")
        double outputRate,
    @Variable(unit = "s", min = 0, max = 30, ifAbsent = 1)
        @Description("Maximum age at which a late measurement is still fused, at its own time.")
        double horizon,
    @Variable(min = 8, max = 20000, ifAbsent = 512)
        @Description("Number of past measurements kept for fusing late ones; about 7 kB each.")
        int history,
    @Variable(min = 0, ifAbsent = 0)
        @Description(
            "Random walk of the horizontal velocity without an accelerometer, in m/s per √s; 0: the domain's (GROUND 0.7, AIR 2, WATER and UNDERWATER 0.3).")
        double accelerationNoise,
    @Variable(min = 0, ifAbsent = 0)
        @Description(
            "Random walk of the vertical velocity without an accelerometer, in m/s per √s; 0: the domain's (GROUND and WATER 0.1, AIR 1, UNDERWATER 0.2).")
        double verticalNoise,
    @Variable(unit = "rad/s", min = 0, ifAbsent = 0)
        @Description(
            "Turn rate, 1 sigma, without a gyroscope; 0: the domain's (GROUND 0.5, AIR 0.3, WATER and UNDERWATER 0.2).")
        double turnSigma,
    @Variable(unit = "m/s", min = 0, ifAbsent = 0)
        @Description(
            "Sideways speed, 1 sigma, over ground (GROUND) or through air or water; 0: the domain's (0.1, AIR 2, WATER 0.3, UNDERWATER 0.2).")
        double sideSlipSigma,
    @Variable(unit = "s", min = 0, ifAbsent = 0.2)
        @Description(
            "Interval of the no-sideslip (non-holonomic) constraint; 0: none, for vehicles that move in all directions.")
        double constraintInterval,
    @Variable(unit = "rad/s", min = 0, minExcluded = true, ifAbsent = 0.02)
        @Description("Initial bias of gyroscopes, 1 sigma.")
        double gyroBiasSigma,
    @Variable(min = 0, ifAbsent = 1e-4)
        @Description("Random walk of the bias of gyroscopes, in rad/s per √s.")
        double gyroBiasNoise,
    @Variable(unit = "m/s^2", min = 0, minExcluded = true, ifAbsent = 0.2)
        @Description("Initial bias of accelerometers, 1 sigma.")
        double accelerometerBiasSigma,
    @Variable(min = 0, ifAbsent = 1e-3)
        @Description("Random walk of the bias of accelerometers, in m/s² per √s.")
        double accelerometerBiasNoise,
    @Variable(unit = "m/s", min = 0, minExcluded = true, ifAbsent = 5)
        @Description("Initial wind or current, 1 sigma of each component.")
        double flowSigma,
    @Variable(min = -1, max = 0.5, ifAbsent = -1)
        @Description(
            "Scale error of speeds along the vehicle, 1 sigma, which the filter estimates; 0: none; -1: 0.03 for GROUND, 0.02 for WATER and UNDERWATER, otherwise none.")
        double wheelScaleSigma,
    @Variable(unit = "m/s", min = -1, max = 1, ifAbsent = -1)
        @Description(
            "Constant error of speeds over ground measured along the vehicle, such as a velocity log's, 1 sigma of each component, which the filter estimates; 0: none; -1: 0.02 m/s for WATER, 0.002 m/s for UNDERWATER, otherwise none.")
        double speedBiasSigma,
    @Variable(unit = "deg", min = -1, max = 45, ifAbsent = -1)
        @Description(
            "Error of a velocity log's mounting about the vertical, 1 sigma, which the filter estimates; 0: none; -1: 2 deg for WATER and UNDERWATER, otherwise none.")
        double logYawSigma,
    @Variable(min = 2, max = 20, ifAbsent = 4)
        @Description("Gate, in standard deviations, beyond which a measurement is rejected.")
        double gate,
    @Variable(unit = "s", min = 0, ifAbsent = 30)
        @Description(
            "Time for which errors of position sources persist: a receiver's error wanders over many seconds and does not average out. 0: errors are independent.")
        double positionCorrelation,
    @Variable(unit = "s", min = 0, ifAbsent = 60)
        @Description(
            "Time for which errors of heading sources persist: a compass's deviation stays while the vehicle keeps its direction. 0: errors are independent.")
        double headingCorrelation,
    @Variable(unit = "s", min = 0, max = 1, ifAbsent = 0.1)
        @Description(
            "Uncertainty of the delays of position sources, 1 sigma: the filter estimates the deviation from their services' DELAY. 0: exactly known.")
        double delaySigma,
    @Variable(unit = "deg", min = -180, max = 180, ifAbsent = 0)
        @Description("Longitude of the surveyed place where each run starts.")
        double startX,
    @Variable(unit = "deg", min = -90, max = 90, ifAbsent = 0)
        @Description("Latitude of the surveyed place where each run starts.")
        double startY,
    @Variable(unit = "m", min = 0, max = 1000, ifAbsent = 0)
        @Description(
            "Accuracy of the starting position, 1 sigma; 0: unknown. A receiver that contradicts it by more than the gate takes precedence.")
        double startSigma,
    @Variable(unit = "deg", min = -360, max = 360, ifAbsent = 0)
        @Description("Heading at the start, clockwise from true north.")
        double startPsi,
    @Variable(unit = "deg", min = 0, max = 90, ifAbsent = 0)
        @Description(
            "Accuracy of START PSI, 1 sigma; 0: it is unknown and, without a compass, found from the first motion.")
        double startPsiSigma,
    @Variable(ifAbsentText = "false")
        @Description(
            "Whether START X and START Y apply even without a position receiver, as for a submarine that dead-reckons.")
        boolean startWithoutReceiver,
    @Variable(ifAbsentText = "")
        @Description(
            "Positions of sensors away from the vehicle's reference point: \"SENSOR NAME = FORWARD LEFT DOWN; …\" in metres, like MOUNTED X, Y, Z of other sensors. A name covers all parts of a sensor, such as \"ImuSensor inertial\".")
        String leverArms,
    @Variable(ifAbsentText = "")
        @Description(
            "Names of the sensors whose speeds through the fluid count, separated by commas, for a vehicle with both air and water sensors; empty: all.")
        String fluidSensors,
    @Variable(unit = "m^2", min = 0, max = 1e5, ifAbsent = 0)
        @Description(
            "Side area of a boat above the water: WIND SENSORS then determine its sideways drift through the water, replacing the no-sideslip constraint. 0: none.")
        double sailArea,
    @Variable(unit = "kg", min = 0.01, max = 1e9, ifAbsent = 100)
        @Description("Mass of the boat, including the added mass in sway; for SAIL AREA.")
        double displacement,
    @Variable(min = 0.01, max = 1e9, ifAbsent = 100)
        @Description("Drag of the hull sideways through the water, in N s/m; for SAIL AREA.")
        double swayDrag,
    @Variable(min = 0, max = 1e9, ifAbsent = 0)
        @Description("Quadratic part of that drag, in N s²/m².")
        double swaySquareDrag,
    @Variable(ifAbsentText = "WindSensor")
        @Description("Names of the wind sensors that SAIL AREA uses, separated by commas.")
        String windSensors,
    @Variable(unit = "s", min = 0.1, ifAbsent = 5)
        @Description("Time after which a quantity is reset if all its sources contradict it.")
        double resetAfter,
    @Variable(unit = "m", min = 0, minExcluded = true, ifAbsent = 25)
        @Description("Standard deviation beyond which a position is not published.")
        double lostSigma,
    @Variable(unit = "m", min = 0, minExcluded = true, ifAbsent = 3)
        @Description("Sigma of positions reported without one.")
        double positionSigma,
    @Variable(unit = "m/s", min = 0, minExcluded = true, ifAbsent = 0.3)
        @Description("Sigma of velocities reported without one.")
        double velocitySigma,
    @Variable(unit = "rad", min = 0, minExcluded = true, ifAbsent = 0.05)
        @Description("Sigma of roll, pitch and heading reported without one.")
        double attitudeSigma,
    @Variable(unit = "rad/s", min = 0, minExcluded = true, ifAbsent = 0.015)
        @Description("Sigma of angular rates reported without one.")
        double rateSigma,
    @Variable(unit = "m/s^2", min = 0, minExcluded = true, ifAbsent = 0.35)
        @Description("Sigma of specific forces reported without one.")
        double forceSigma,
    @Variable(unit = "m/s", min = 0, minExcluded = true, ifAbsent = 1)
        @Description("Sigma of speeds through air or water reported without one.")
        double fluidSigma) {
  FusionVariables {
    try {
      new LeverArms(leverArms);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("LEVER ARMS: " + e.getMessage(), e);
    }
  }

  FilterTuning tuning() {
    FilterTuning usual = FilterTuning.of(domain);
    return new FilterTuning(
        domain,
        or(accelerationNoise, usual.accelerationNoise()),
        or(verticalNoise, usual.verticalNoise()),
        or(turnSigma, usual.turnSigma()),
        or(sideSlipSigma, usual.sideSlipSigma()),
        sailArea > 0.0 ? 0.0 : constraintInterval,
        gyroBiasSigma,
        gyroBiasNoise,
        accelerometerBiasSigma,
        accelerometerBiasNoise,
        flowSigma,
        wheelScaleSigma < 0.0 ? usual.wheelScaleSigma() : wheelScaleSigma,
        speedBiasSigma < 0.0 ? usual.speedBiasSigma() : speedBiasSigma,
        logYawSigma < 0.0 ? usual.logYawSigmaRad() : Math.toRadians(logYawSigma),
        gate,
        usual.window(),
        positionCorrelation,
        headingCorrelation,
        delaySigma,
        resetAfter,
        lostSigma,
        horizon,
        history);
  }

  private static double or(double set, double usual) {
    return set > 0.0 ? set : usual;
  }

  UsualSigmas sigmas() {
    return new UsualSigmas(
        positionSigma, velocitySigma, attitudeSigma, rateSigma, forceSigma, fluidSigma);
  }

  /** Sensors whose speeds through the fluid count; empty: all. */
  Set<String> fluid() {
    Set<String> named = names(fluidSensors);
    if (sailArea > 0.0 && !named.isEmpty()) {
      named.addAll(names(windSensors)); // they determine the drift
    }
    return named;
  }

  /** Drift from the wind; empty if unused. */
  Optional<SailDrift> sailDrift() {
    return sailArea == 0.0
        ? Optional.empty()
        : Optional.of(
            new SailDrift(
                names(windSensors),
                new SailDrift.Hull(sailArea, displacement, swayDrag, swaySquareDrag),
                tuning().sideSlipSigma(),
                constraintInterval));
  }

  /** Sensors that variables name. */
  Set<String> sensors() {
    Set<String> sensors = fluid();
    sensors.addAll(new LeverArms(leverArms).sensors());
    if (sailArea > 0.0) {
      sensors.addAll(names(windSensors));
    }
    return sensors;
  }

  private static Set<String> names(String list) {
    return Stream.of(list.split(","))
        .map(String::trim)
        .filter(name -> !name.isEmpty())
        .collect(Collectors.toCollection(TreeSet::new));
  }
}
