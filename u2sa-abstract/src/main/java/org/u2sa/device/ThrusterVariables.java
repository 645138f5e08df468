package org.u2sa.device;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Configuration variables of {@link ThrusterActuator}, except its {@link MountingPose}. */
record ThrusterVariables(
    @Variable(ifAbsentText = "")
        @Description(
            "Name to which commands are addressed, unique in the system; empty: the service's name.")
        String actuatorName,
    @Variable(ifAbsentText = "false") @Description("Whether positive power pushes backwards.")
        boolean reversed,
    @Variable(unit = "%", min = -100, max = 0, ifAbsent = -100)
        @Description("Maximum reverse command; 0 for a propeller that turns one way.")
        double minimum,
    @Variable(unit = "%", min = 1, max = 100, ifAbsent = 100)
        @Description("Maximum forward command.")
        double maximum,
    @Variable(unit = "%", min = 0, max = 50, ifAbsent = 0)
        @Description(
            "Dead band: the motor does not start below this command, so smaller ones count as 0.")
        double deadband,
    @Variable(unit = "%/s", min = 1, max = 100_000, ifAbsent = 400)
        @Description("Maximum rate of change of a command; stops are not limited.")
        double slewLimit,
    @Variable(unit = "N", min = 0, max = 1.0e6, ifAbsent = 0)
        @Description("Thrust at 100 %, from the data sheet, for the announcement; 0: unknown.")
        double fullThrust,
    @Variable(unit = "N", min = 0, max = 1.0e6, ifAbsent = 0)
        @Description("Reverse thrust at -100 %, for the announcement; 0: same as FULL THRUST.")
        double reverseThrust,
    @Variable(unit = "N m", min = -1.0e6, max = 1.0e6, ifAbsent = 0)
        @Description(
            "Torque on the vehicle about the direction of thrust at FULL THRUST, for the announcement: positive for a rotor that turns anticlockwise when viewed against the thrust direction.")
        double fullTorque,
    @Variable(unit = "s", min = 0.05, max = 60, ifAbsent = 1)
        @Description(
            "Time after which a connected thruster counts as silent, or as stalled if it is commanded and does not turn.")
        double timeout) {}
