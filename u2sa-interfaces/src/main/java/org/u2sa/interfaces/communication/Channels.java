package org.u2sa.interfaces.communication;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.GroundPressure;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.mission.GoalClass;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceOrderResult;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.safety.ManualDrive;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.safety.OperatorHeartbeat;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;

/** The standard channels between the services of a vehicle (thesis figures 4 and 16). */
public final class Channels {
  /** Proprioceptive measurements; to the State Estimator. */
  public static final Channel<StateInformation> SENSED_STATE =
      Channel.latest("sensed-state", StateInformation.TYPE, StateInformation::sensorName);

  /** The State Estimator's best estimate; to planner, world modeler, control and screens. */
  public static final Channel<StateInformation> STATE =
      Channel.latest("state", StateInformation.TYPE, StateInformation::sensorName);

  /**
   * The State Estimator's dead reckoning in a local frame that never jumps, in addition to {@link
   * #STATE}; for maps and control.
   */
  public static final Channel<StateInformation> LOCAL_STATE =
      Channel.latest("local-state", StateInformation.TYPE, StateInformation::sensorName);

  /** Detections of exteroceptive sensors; to the World Modeler. */
  public static final Channel<ObjectDescription> SENSED_OBJECTS =
      Channel.every("sensed-objects", ObjectDescription.TYPE, ObjectDescription::sensorName);

  /** Lidar and sonar scans, beam by beam; to the World Modeler. */
  public static final Channel<RangeScan> SCANS =
      Channel.latest("scans", RangeScan.TYPE, RangeScan::sensorName);

  /** Camera images at a low rate; to recorders and screens. */
  public static final Channel<CameraImage> IMAGES =
      Channel.latest("images", CameraImage.TYPE, CameraImage::sensorName);

  /** The World Modeler's objects; to the planner. */
  public static final Channel<ObjectList> OBJECTS =
      Channel.latest("objects", ObjectList.TYPE, list -> "").retained();

  /** Occupancy grid around the vehicle; to planner and screens. */
  public static final Channel<OccupancyGrid> GRID =
      Channel.latest("grid", OccupancyGrid.TYPE, grid -> "").retained();

  /** The Mission Manager's current goals; to the planner and task-dependent services. */
  public static final Channel<GoalList> GOALS =
      Channel.latest("goals", GoalList.TYPE, list -> "").retained();

  /** Completed goals from the planner; to the Mission Manager. */
  public static final Channel<GoalInformation> GOAL_REPORTS =
      Channel.every("goal-reports", GoalInformation.TYPE);

  /** New or changed goals; to the Mission Manager. */
  public static final Channel<GoalInformation> GOAL_UPDATES =
      Channel.every("goal-updates", GoalInformation.TYPE);

  /** Commands to switch to another goal; to the Mission Manager. */
  public static final Channel<GoalCommand> GOAL_COMMANDS =
      Channel.every("goal-commands", GoalCommand.TYPE);

  /** Mission status, and operators' commands that change it, each with its response. */
  public static final Channel<U2SAData> MISSION =
      Channel.every("mission", U2SAData.TYPE)
          .carrying(
              MissionRequest.TYPE,
              GoalClass.TYPE,
              MissionReport.TYPE,
              MissionOrder.TYPE,
              MissionOrderResult.TYPE);

  /** Next navigation point of each subsystem; to control. */
  public static final Channel<NavigationPoint> NAVIGATION =
      Channel.latest("navigation", NavigationPoint.TYPE, NavigationPoint::subsystem);

  /** Planned paths; to screens. */
  public static final Channel<PlannedPath> PLANS =
      Channel.latest("plans", PlannedPath.TYPE, PlannedPath::subsystem).retainedBySource();

  /** Commands to actuators, each addressed by name. */
  public static final Channel<ActuatorCommand> ACTUATION =
      Channel.latest("actuation", ActuatorCommand.TYPE, ActuatorCommand::actuatorName);

  /** Actuator announcements (thesis 5.1); to control. */
  public static final Channel<ActuatorAnnouncement> ACTUATORS =
      Channel.latest("actuators", ActuatorAnnouncement.TYPE, ActuatorAnnouncement::actuatorName)
          .retainedBySource();

  /** Service discovery: requests and responses (thesis 3.2.2.1). */
  public static final Channel<U2SAData> DISCOVERY =
      Channel.every("discovery", U2SAData.TYPE)
          .carrying(DiscoveryRequest.TYPE, DiscoveryResponse.TYPE);

  /** Channels a service publishes and subscribes to: requests and responses (thesis 3.2.2.1). */
  public static final Channel<U2SAData> FUNCTIONALITY =
      Channel.every("functionality", U2SAData.TYPE)
          .carrying(FunctionalityRequest.TYPE, FunctionalityResponse.TYPE);

  /** Commands to stop one service or all (thesis 3.2.2.1). */
  public static final Channel<StopCommand> STOP = Channel.every("stop", StopCommand.TYPE);

  /** Configuration variables: requests, changes and results (thesis 3.2.2.1). */
  public static final Channel<U2SAData> CONFIGURATION =
      Channel.every("configuration", U2SAData.TYPE)
          .carrying(
              ConfigurationRequest.TYPE,
              ConfigurationResponse.TYPE,
              ConfigurationChange.TYPE,
              ConfigurationChangeResult.TYPE,
              ConfigurationTransaction.TYPE,
              ConfigurationUndo.TYPE,
              ConfigurationTransactionResult.TYPE);

  /** Health reports of the services (thesis 3.5.3). */
  public static final Channel<HealthReport> HEALTH =
      Channel.latest("health", HealthReport.TYPE, Channels::reporter);

  /** Conditions of the services as seen by the Health Monitor, and its actions (thesis 3.5.3). */
  public static final Channel<ServiceCondition> CONDITIONS =
      Channel.latest("conditions", ServiceCondition.TYPE, ServiceCondition::serviceName)
          .retainedBySource();

  /** Commands to launchers to start, restart or swap a service, and their results. */
  public static final Channel<U2SAData> SERVICE_ORDERS =
      Channel.every("service-orders", U2SAData.TYPE)
          .carrying(ServiceOrder.TYPE, ServiceOrderResult.TYPE);

  /** The emergency stop, latched until an operator clears it. */
  public static final Channel<EmergencyStop> EMERGENCY_STOP =
      Channel.every("emergency-stop", EmergencyStop.TYPE).retained().urgent();

  /** Active failsafe action; to planner, Mission Manager and control. */
  public static final Channel<FailsafeState> FAILSAFE =
      Channel.latest("failsafe", FailsafeState.TYPE, state -> "").retained().reservingRoom();

  /** Operator heartbeats. */
  public static final Channel<OperatorHeartbeat> OPERATOR =
      Channel.latest("operator", OperatorHeartbeat.TYPE, OperatorHeartbeat::operator);

  /** Arming and disarming requests. */
  public static final Channel<ArmCommand> ARMING =
      Channel.every("arming", ArmCommand.TYPE).reservingRoom();

  /** Arming state; to actuators and screens. */
  public static final Channel<ArmingState> ARMING_STATE =
      Channel.latest("arming-state", ArmingState.TYPE, state -> "").retained().reservingRoom();

  /** The geofence in force; to screens. */
  public static final Channel<FenceState> FENCE =
      Channel.latest("fence", FenceState.TYPE, state -> "").retained();

  /** Operators' orders to change the geofence, and their results. */
  public static final Channel<U2SAData> FENCE_ORDERS =
      Channel.every("fence-orders", U2SAData.TYPE).carrying(FenceOrder.TYPE, FenceOrderResult.TYPE);

  /** Requests to begin or end driving by hand; to control. */
  public static final Channel<ManualOrder> MANUAL_ORDERS =
      Channel.every("manual-orders", ManualOrder.TYPE);

  /** Whether the vehicle is driven by hand; to the Mission Manager and screens. */
  public static final Channel<ManualState> MANUAL_STATE =
      Channel.latest("manual-state", ManualState.TYPE, state -> "").retained();

  /** Motion commanded by the person who drives by hand; to control. */
  public static final Channel<ManualDrive> MANUAL_DRIVE =
      Channel.latest("manual-drive", ManualDrive.TYPE, ManualDrive::operator);

  /** Battery states. */
  public static final Channel<BatteryState> POWER =
      Channel.latest("power", BatteryState.TYPE, BatteryState::sensorName);

  /** Air pressure at the ground station; to sensors of pressure altitude. */
  public static final Channel<GroundPressure> GROUND_PRESSURE =
      Channel.latest("ground-pressure", GroundPressure.TYPE, pressure -> "").retained();

  private static final List<Channel<?>> ALL =
      List.of(
          SENSED_STATE,
          STATE,
          LOCAL_STATE,
          SENSED_OBJECTS,
          SCANS,
          IMAGES,
          OBJECTS,
          GRID,
          GOALS,
          GOAL_REPORTS,
          GOAL_UPDATES,
          GOAL_COMMANDS,
          MISSION,
          NAVIGATION,
          PLANS,
          ACTUATION,
          ACTUATORS,
          DISCOVERY,
          FUNCTIONALITY,
          STOP,
          CONFIGURATION,
          HEALTH,
          CONDITIONS,
          SERVICE_ORDERS,
          EMERGENCY_STOP,
          FAILSAFE,
          OPERATOR,
          ARMING,
          ARMING_STATE,
          FENCE,
          FENCE_ORDERS,
          MANUAL_ORDERS,
          MANUAL_STATE,
          MANUAL_DRIVE,
          POWER,
          GROUND_PRESSURE);

  private static final Map<String, Channel<?>> BY_NAME =
      ALL.stream().collect(Collectors.toMap(Channel::name, channel -> channel));

  private Channels() {}

  /**
   * Reporter on a service: the service itself, the broker about its connection, or a supervisor
   * about its process. Reports of different reporters do not replace each other.
   */
  private static String reporter(HealthReport report) {
    if (!(report instanceof ConnectionLost)) {
      return report.serviceName();
    }
    return report.serviceName() + (report.threadAlive().isPresent() ? " (process)" : " (link)");
  }

  /** All standard channels. */
  public static List<Channel<?>> all() {
    return ALL;
  }

  /** Standard channel by name. */
  public static Optional<Channel<?>> named(String name) {
    return Optional.ofNullable(BY_NAME.get(name));
  }

  /** Standard channel by name, or else {@link Channel#undeclared}. */
  public static Channel<? extends U2SAData> namedOrNew(String name) {
    Optional<Channel<?>> standard = named(name);
    return standard.isPresent() ? standard.get() : Channel.undeclared(name);
  }
}
