package org.u2sa.control.cascade;

import org.u2sa.interfaces.configuration.Variable;

/** Variables of the control of motion along one axis of the vehicle. */
record LinearAxis(
    @Variable(
            min = 0,
            max = 1000,
            ifAbsent = 0,
            text = "Weight of the axis when actuators saturate; 0: the axis is not controlled.")
        double weight,
    @Variable(
            unit = "kg",
            min = 0.001,
            max = 1.0e7,
            ifAbsent = 1,
            text = "Mass, including the added mass of the water.")
        double mass,
    @Variable(
            unit = "1/s",
            min = 0,
            max = 100,
            ifAbsent = 1,
            text = "Acceleration per velocity error.")
        double gain,
    @Variable(
            unit = "s",
            min = 0,
            max = 1000,
            ifAbsent = 4,
            text = "Integral time of the velocity loop; 0: no integral.")
        double integralTime,
    @Variable(
            unit = "s",
            min = 0,
            max = 100,
            ifAbsent = 0,
            text = "Derivative time of the velocity loop; 0: no derivative.")
        double derivativeTime,
    @Variable(
            unit = "1/s",
            min = 0,
            max = 10,
            ifAbsent = 0.3,
            text = "Velocity per distance to the navigation point.")
        double positionGain,
    @Variable(
            unit = "m/s",
            min = 0,
            max = 100,
            ifAbsent = 0.5,
            text = "Maximum speed along the axis.")
        double maxSpeed) {

  AxisTuning tuning() {
    return new AxisTuning(
        weight, mass, AxisTuning.gains(gain, integralTime, derivativeTime), positionGain, maxSpeed);
  }
}
