package org.u2sa.control.fixedwing.law;

import org.u2sa.interfaces.configuration.Variable;

/**
 * Gains and limits of {@link EnergyLaw}. Energy rates are angles, γ + V̇/g, so that the aircraft's
 * weight does not appear.
 */
public record EnergyVariables(
    @Variable(unit = "s", min = 1, max = 30, ifAbsent = 4, text = "Altitude-error time constant.")
        double altitudeTimeConstant,
    @Variable(unit = "s", min = 1, max = 30, ifAbsent = 6, text = "Airspeed-error time constant.")
        double speedTimeConstant,
    @Variable(unit = "m/s", min = 0.5, max = 10, ifAbsent = 3.5, text = "Maximum demanded climb.")
        double climbLimit,
    @Variable(unit = "m/s", min = 0.5, max = 10, ifAbsent = 4, text = "Maximum demanded sink rate.")
        double sinkLimit,
    @Variable(
            unit = "m/s^2",
            min = 0.1,
            max = 5,
            ifAbsent = 0.8,
            text = "Maximum rate of change of the demanded climb rate.")
        double verticalAccelerationLimit,
    @Variable(unit = "m/s^2", min = 0.1, max = 5, ifAbsent = 1, text = "Maximum acceleration.")
        double accelerationLimit,
    @Variable(
            unit = "s",
            min = 0.05,
            max = 20,
            ifAbsent = 1,
            text = "Time constant of the airspeed low-pass; longer is calmer in gusts.")
        double airspeedFilter,
    @Variable(min = 0, max = 1, ifAbsent = 0.6, text = "Throttle of level cruise.")
        double throttleTrim,
    @Variable(unit = "1/rad", min = 0, max = 20, ifAbsent = 2.5, text = "Throttle per energy rate.")
        double throttleForwardGain,
    @Variable(
            unit = "1/rad",
            min = 0,
            max = 20,
            ifAbsent = 0.7,
            text = "Throttle per energy-rate error.")
        double throttleDamping,
    @Variable(
            unit = "1/rad/s",
            min = 0,
            max = 20,
            ifAbsent = 0.4,
            text = "Throttle per integrated energy-rate error.")
        double throttleIntegralGain,
    @Variable(min = 0, max = 1, ifAbsent = 0, text = "Minimum throttle in flight.")
        double throttleLowerLimit,
    @Variable(min = 0, max = 1, ifAbsent = 1, text = "Maximum throttle in cruise.")
        double throttleUpperLimit,
    @Variable(unit = "1/s", min = 0.01, max = 5, ifAbsent = 0.3, text = "Maximum throttle rate.")
        double throttleRateLimit,
    @Variable(
            unit = "rad",
            min = 0,
            max = 0.5,
            ifAbsent = 0.037,
            text =
                "Induced drag over weight in level flight; grows in turns with the square of the load factor.")
        double turnDrag,
    @Variable(min = 0, max = 5, ifAbsent = 0.8, text = "Pitch per energy-balance error.")
        double energyBalanceGain,
    @Variable(
            unit = "1/s",
            min = 0,
            max = 5,
            ifAbsent = 0.3,
            text = "Pitch per integrated energy-balance error.")
        double energyBalanceIntegralGain,
    @Variable(
            unit = "deg/s",
            min = 0.5,
            max = 20,
            ifAbsent = 3,
            text = "Maximum rate of the demanded pitch.")
        double pitchDemandRateLimit,
    @Variable(
            unit = "m/s",
            min = 2,
            max = 40,
            ifAbsent = 20,
            text = "Minimum airspeed for computing flight-path angles.")
        double minSpeed) {}
