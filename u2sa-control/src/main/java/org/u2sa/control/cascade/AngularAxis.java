package org.u2sa.control.cascade;

import org.u2sa.interfaces.configuration.Variable;

/** Variables of the control of rotation about one axis of the vehicle. */
record AngularAxis(
    @Variable(
            min = 0,
            max = 1000,
            ifAbsent = 0,
            text = "Weight of the axis when actuators saturate; 0: the axis is not controlled.")
        double weight,
    @Variable(
            min = 1.0e-6,
            max = 1.0e7,
            ifAbsent = 1,
            text = "Moment of inertia, including that of the water [kg m²].")
        double inertia,
    @Variable(
            unit = "1/s",
            min = 0,
            max = 100,
            ifAbsent = 2,
            text = "Angular acceleration per rate error.")
        double gain,
    @Variable(
            unit = "s",
            min = 0,
            max = 1000,
            ifAbsent = 2,
            text = "Integral time of the rate loop; 0: no integral.")
        double integralTime,
    @Variable(
            unit = "s",
            min = 0,
            max = 100,
            ifAbsent = 0,
            text = "Derivative time of the rate loop; 0: no derivative.")
        double derivativeTime,
    @Variable(unit = "1/s", min = 0, max = 20, ifAbsent = 0.8, text = "Rate per angle error.")
        double angleGain,
    @Variable(unit = "deg/s", min = 0, max = 1000, ifAbsent = 30, text = "Fastest rotation.")
        double maxRate) {

  AxisTuning tuning() {
    return new AxisTuning(
        weight,
        inertia,
        AxisTuning.gains(gain, integralTime, derivativeTime),
        angleGain,
        Math.toRadians(maxRate));
  }
}
