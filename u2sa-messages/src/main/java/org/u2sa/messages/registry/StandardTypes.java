package org.u2sa.messages.registry;

import java.util.List;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.GroundPressure;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.command.ForceCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.command.SpeedCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.ConfigurationVariable;
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
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.marine.Bin;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Button;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.marine.HotTarget;
import org.u2sa.messages.marine.PathMarker;
import org.u2sa.messages.marine.Pole;
import org.u2sa.messages.marine.Puck;
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
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.CoverageLedger;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.ShapeDescription;
import org.u2sa.messages.shape.Sphere;

/** Registers the messages of this module. */
public final class StandardTypes implements MessageTypeProvider {
  private static final List<MessageType<?>> ALL =
      List.of(
          StateInformation.TYPE,
          GoalInformation.TYPE,
          Waypoint.TYPE,
          GoalList.TYPE,
          ObjectDescription.TYPE,
          PointCloud.TYPE,
          ShapeDescription.TYPE,
          Circle.TYPE,
          Rectangle.TYPE,
          Line.TYPE,
          Sphere.TYPE,
          Cylinder.TYPE,
          Box.TYPE,
          ObjectList.TYPE,
          NavigationPoint.TYPE,
          ActuatorCommand.TYPE,
          PercentageCommand.TYPE,
          ActuatorAnnouncement.TYPE,
          GoalCommand.TYPE,
          DiscoveryRequest.TYPE,
          DiscoveryResponse.TYPE,
          FunctionalityRequest.TYPE,
          FunctionalityResponse.TYPE,
          StopCommand.TYPE,
          ConfigurationRequest.TYPE,
          ConfigurationVariable.TYPE,
          ConfigurationResponse.TYPE,
          ConfigurationChange.TYPE,
          ConfigurationChangeResult.TYPE,
          HealthReport.TYPE,
          ConnectionLost.TYPE,
          EmergencyStop.TYPE,
          ServiceOrder.TYPE,
          ServiceOrderResult.TYPE,
          ServiceCondition.TYPE,
          FailsafeState.TYPE,
          FenceState.TYPE,
          FenceOrder.TYPE,
          FenceOrderResult.TYPE,
          ManualOrder.TYPE,
          ManualState.TYPE,
          ManualDrive.TYPE,
          OperatorHeartbeat.TYPE,
          ArmCommand.TYPE,
          ArmingState.TYPE,
          ConfigurationAssignment.TYPE,
          ConfigurationTransaction.TYPE,
          ConfigurationUndo.TYPE,
          ConfigurationTransactionResult.TYPE,
          BatteryState.TYPE,
          GroundPressure.TYPE,
          RangeScan.TYPE,
          InertialMeasurement.TYPE,
          LandmarkSighting.TYPE,
          Polygon.TYPE,
          PolyLine.TYPE,
          MovingSphere.TYPE,
          OccupancyGrid.TYPE,
          PlannedPath.TYPE,
          ObjectGoal.TYPE,
          Station.TYPE,
          TakeOff.TYPE,
          Landing.TYPE,
          PayloadDrop.TYPE,
          SearchArea.TYPE,
          ImageFootprint.TYPE,
          CoverageLedger.TYPE,
          MissionRequest.TYPE,
          MissionReport.TYPE,
          GoalClass.TYPE,
          MissionOrder.TYPE,
          MissionOrderResult.TYPE,
          AngleCommand.TYPE,
          SpeedCommand.TYPE,
          ForceCommand.TYPE,
          CameraImage.TYPE,
          AircraftState.TYPE,
          Buoy.TYPE,
          Hoop.TYPE,
          HotTarget.TYPE,
          Puck.TYPE,
          Button.TYPE,
          Dock.TYPE,
          Bin.TYPE,
          PathMarker.TYPE,
          Pole.TYPE);

  /** For {@link java.util.ServiceLoader}. */
  public StandardTypes() {}

  /** Only these types; {@link MessageTypes#discovered()} includes those of other modules. */
  public static MessageTypes registry() {
    return MessageTypes.of(ALL);
  }

  @Override
  public List<MessageType<?>> messageTypes() {
    return ALL;
  }
}
