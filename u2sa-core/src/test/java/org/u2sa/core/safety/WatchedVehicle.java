package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.testkit.ServiceKit;

/**
 * Tests of a SafetyManager with a vehicle that has all it needs to be armed, unless the test says
 * otherwise.
 */
abstract class WatchedVehicle {
  private int commands;
  final ServiceKit kit = new ServiceKit();
  double sigmaM = 1.0;
  boolean position = true;

  @BeforeEach
  void configure() {
    kit.with("ACTUATOR SERVICES", "Motor, Rudder").with("LOW BATTERY VOLTAGE", 11.0);
    kit.with("BATTERY DEADLINE", 3_600.0); // the battery speaks once
    kit.with("CRITICAL BATTERY REMAINING", 10.0).with("ON CRITICAL BATTERY", "STOP");
  }

  @AfterEach
  void close() {
    kit.close();
  }

  void live(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.1) {
      StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU);
      if (position) {
        state.x(0.0).y(0.0);
      }
      state.xSigma(sigmaM);
      kit.send(Channels.STATE, state);
      kit.advance(0.1);
    }
  }

  SafetyManager start() {
    SafetyManager manager = startManager();
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(waypoint())));
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement().actuatorName("MOTOR").minimum(0.0).maximum(100.0));
    battery(12.5, 80.0);
    return manager;
  }

  /** Starts it alone, and waits until no predecessor can be there. */
  SafetyManager startManager() {
    SafetyManager manager = kit.start(SafetyManager::new);
    actuatorServicesReport();
    kit.advance(0.6);
    return manager;
  }

  void actuatorServicesReport() {
    for (String service : List.of("Motor", "Rudder")) {
      kit.publish(
          Channels.HEALTH, new HealthReport().serviceName(service).status(ServiceStatus.RUNNING));
    }
  }

  static Waypoint waypoint() {
    return new Waypoint().uid("1").x(1.0).y(1.0).horizontalThreshold(1.0);
  }

  void battery(double volts, double percent) {
    kit.publish(
        Channels.POWER, new BatteryState().sensorName("main").voltage(volts).remaining(percent));
  }

  ArmingState arm(boolean arm) {
    return arm(armCommand(arm));
  }

  /** IDs count from 7. */
  ArmCommand armCommand(boolean arm) {
    return new ArmCommand().requestId(String.valueOf(7 + commands++)).arm(arm).operator("Ann");
  }

  ArmingState arm(ArmCommand command) {
    kit.publish(Channels.ARMING, command);
    kit.advance(0.1);
    return kit.published(Channels.ARMING_STATE).stream()
        .filter(state -> state.requestId().isPresent())
        .reduce((first, second) -> second)
        .orElseThrow();
  }

  void startArmed() {
    startArmedManager();
  }

  SafetyManager startArmedManager() {
    SafetyManager manager = start();
    live(0.3);
    assertThat(arm(true).armed()).isTrue();
    return manager;
  }

  FailsafeState failsafe() {
    return kit.latest(Channels.FAILSAFE).orElseThrow();
  }

  void condition(String service, Condition condition) {
    kit.publish(Channels.CONDITIONS, given(service, condition));
  }

  static ServiceCondition given(String service, Condition condition) {
    return new ServiceCondition().serviceName(service).condition(condition).reason("seen so");
  }
}
