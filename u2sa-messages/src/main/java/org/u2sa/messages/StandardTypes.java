package org.u2sa.messages;

import java.util.List;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ArmCommand;
import org.u2sa.messages.contract.ArmingState;
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
import org.u2sa.messages.contract.EmergencyStop;
import org.u2sa.messages.contract.FailsafeState;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.GoalCommand;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.OperatorHeartbeat;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.contract.StopCommand;

/** The registry of this module's own messages: one line each. */
final class StandardTypes {
  static final List<MessageType<?>> ALL =
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
          OperatorHeartbeat.TYPE,
          ArmCommand.TYPE,
          ArmingState.TYPE,
          ConfigurationAssignment.TYPE,
          ConfigurationTransaction.TYPE,
          ConfigurationUndo.TYPE,
          ConfigurationTransactionResult.TYPE,
          BatteryState.TYPE,
          RangeScan.TYPE);

  private StandardTypes() {}
}
