package org.u2sa.core.safety;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** The configuration variables of the {@link SafetyManager}, except the matrix ({@link Hazard}). */
record SafetyVariables(
    @Variable(unit = "s", min = 0.05, max = 3600, ifAbsent = 5)
        @Description("Time without an operator's heartbeat after which the link counts as lost.")
        double operatorDeadline,
    @Variable(unit = "s", min = 0, max = 86_400, ifAbsent = 0)
        @Description(
            "Time without an operator's heartbeat after which ON LONG OPERATOR LOSS applies; 0: never.")
        double longOperatorDeadline,
    @Variable(ifAbsentText = "false")
        @Description(
            "Whether arming requires an operator; otherwise the link counts from the first heartbeat.")
        boolean operatorRequired,
    @Variable(unit = "s", min = 0.05, max = 3600, ifAbsent = 1)
        @Description("Age at which the state estimate counts as absent.")
        double stateDeadline,
    @Variable(unit = "m", min = 0, minExcluded = true, ifAbsent = 50)
        @Description(
            "Standard deviation of x or y above which the position counts as lost; a state without one is trusted.")
        double positionSigmaLimit,
    @Variable(ifAbsentText = "true")
        @Description(
            "Whether arming requires a position; false for vehicles that find their way by sight alone.")
        boolean positionRequired,
    @Variable(ifAbsentText = SafetyVariables.DEFAULT_ESTIMATOR)
        @Description("Service that estimates the vehicle's state.")
        String estimatorService,
    @Variable(ifAbsentText = "")
        @Description(
            "Services whose failure counts as loss of the actuator link, separated by commas; only their refusals count. Empty: refusals of all services count.")
        String actuatorServices,
    @Variable(unit = "s", min = 0.1, max = 3600, ifAbsent = 2)
        @Description(
            "Time for which a service's actuators must refuse every command, while armed, to count as a failure.")
        double refusalTime,
    @Variable(ifAbsentText = "HealthMonitor") @Description("Name of the health monitor.")
        String healthMonitorService,
    @Variable(unit = "s", min = 0.05, max = 3600, ifAbsent = 4)
        @Description("Time without a report from the health monitor after which it counts as lost.")
        double healthMonitorDeadline,
    @Variable(ifAbsentText = "false")
        @Description(
            "Whether arming requires a health monitor; otherwise it counts from its first report.")
        boolean healthMonitorRequired,
    @Variable(unit = "V", min = 0, ifAbsent = 0)
        @Description("Low-battery threshold; 0: not monitored.")
        double lowBatteryVoltage,
    @Variable(unit = "%", min = 0, max = 100, ifAbsent = 0)
        @Description("Low-battery charge; 0: not monitored.")
        double lowBatteryRemaining,
    @Variable(unit = "V", min = 0, ifAbsent = 0) @Description("Critical voltage; 0: not monitored.")
        double criticalBatteryVoltage,
    @Variable(unit = "%", min = 0, max = 100, ifAbsent = 0)
        @Description("Critical charge; 0: not monitored.")
        double criticalBatteryRemaining,
    @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 10)
        @Description("Time for which a battery must be below a threshold: voltage sags under load.")
        double batteryTime,
    @Variable(unit = "s", min = 0.05, max = 3600, ifAbsent = 10)
        @Description(
            "Time without a message after which the sensor of a known battery counts as lost, if a threshold is set.")
        double batteryDeadline,
    @Variable(ifAbsentText = "")
        @Description(
            "Sensor names of the monitored batteries, separated by commas, so that spoofed ones are ignored; empty: all.")
        String batteries,
    @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 3)
        @Description("Time for which a cause must be absent before it no longer counts.")
        double clearAfter,
    @Variable(ifAbsentText = "false")
        @Description(
            "Whether RETURN and LAND end with their causes, except the fence; otherwise they last until an operator arms again.")
        boolean resume,
    @Variable(ifAbsentText = "")
        @Description(
            "Service that reports in manual-state that a pilot moves the actuators directly, by radio and multiplexer; failsafes are then suspended. Empty: none.")
        String pilotService,
    @Variable(ifAbsentText = "false")
        @Description("Whether to arm once per run, when all checks first pass.")
        boolean armAtStart,
    @Variable(ifAbsentText = "true") @Description("Whether arming requires a goal.")
        boolean missionRequired,
    @Variable(ifAbsentText = "")
        @Description(
            "Actuators that must be announced before arming, separated by commas; empty: at least one of any name.")
        String requiredActuators,
    @Variable(ifAbsentText = "")
        @Description("Geofence XML file, relative to this one; empty: none.")
        String fence,
    @Variable(
            oneOf = {Manoeuvre.BRAKE, "TURN", Manoeuvre.TURN_TO_ONE_SIDE},
            ifAbsentText = Manoeuvre.BRAKE)
        @Description(
            "How the vehicle stays inside the fence: it BRAKEs or, like an aircraft, TURNs to either side. "
                + "TURN TO ONE SIDE: room on one side is enough, for a planner that knows the boundary.")
        String fenceManoeuvre,
    @Variable(unit = "s", min = 0, max = 60, ifAbsent = 1)
        @Description("Time from the failsafe until the vehicle brakes or turns.")
        double reactionTime,
    @Variable(unit = "m/s^2", min = 0.01, ifAbsent = 1)
        @Description("Deceleration when stopping before the fence.")
        double braking,
    @Variable(unit = "rad", min = 0.01, max = 1.4, ifAbsent = 0.4)
        @Description("Bank of the turn away from the fence.")
        double turnBank,
    @Variable(unit = "m", min = 0, ifAbsent = 0)
        @Description(
            "The planner's LOITER RADIUS: if ON FENCE is HOLD, the vehicle acts while there is still room for this circle.")
        double holdRadius,
    @Variable(unit = "m/s", min = 0, ifAbsent = 0)
        @Description(
            "Speed at which wind, or wind and current, may carry the vehicle over the fence. With FENCE MANOEUVRE = BRAKE, 0 for vehicles that hold wherever they stop.")
        double windAllowance,
    @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 5)
        @Description(
            "With FENCE MANOEUVRE = BRAKE and a WIND ALLOWANCE: time after braking until the vehicle holds against wind and current, such as that of a boat for turning its bow.")
        double driftTime,
    @Variable(unit = "m/s^2", min = 0.01, ifAbsent = 0.8)
        @Description(
            "Vertical acceleration for levelling off below the ceiling or above the floor.")
        double verticalAcceleration,
    @Variable(unit = "m", min = 0, ifAbsent = 0)
        @Description("Margin inside the fence on all sides, for position errors.")
        double fenceMargin) {
  /** Names of the variables that define the fence. */
  static final String FENCE = "FENCE";

  static final String FENCE_MARGIN = "FENCE MARGIN";

  /** Default of ESTIMATOR SERVICE. */
  static final String DEFAULT_ESTIMATOR = "StateEstimator";

  /** Whether a threshold of a battery is set. */
  boolean watchesBatteries() {
    return lowBatteryVoltage > 0.0
        || lowBatteryRemaining > 0.0
        || criticalBatteryVoltage > 0.0
        || criticalBatteryRemaining > 0.0;
  }
}
