package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import io.netty.buffer.Unpooled;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttQoS;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.communication.access.SourceNames;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.mqtt.ClientIds;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** Who may publish under which source name. */
class SourceNamesTest {
  private final PacketPipeline pipeline = new PacketPipeline().introduced();
  private final LocalBus bus = new LocalBus("cessna");
  private final PacketRules first = client("first");
  private final PacketRules second = client("second");
  private final PacketRules ofVehicle = client(ClientIds.of("cessna", "PathPlanner"));

  @AfterEach
  void close() {
    pipeline.close();
  }

  private PacketRules client(String clientId) {
    return new PacketRules(pipeline.broker, null, clientId);
  }

  private static boolean publishes(PacketRules from, Channel<?> channel, U2SAData message) {
    return publishes(from, channel, message, WireForm.READABLE);
  }

  private static boolean publishes(
      PacketRules from, Channel<?> channel, U2SAData message, WireForm form) {
    byte[] payload = new MessageCodec(StandardTypes.registry(), form).encode(message);
    String topic = Topic.of(message.systemId(), channel, message).toString();
    return refusal(from, topic, payload, false).isEmpty();
  }

  private static Optional<String> refusal(
      PacketRules from, String topic, byte[] payload, boolean isRetained) {
    return from.refusalOf(
        MqttMessageBuilders.publish()
            .topicName(topic)
            .qos(MqttQoS.AT_LEAST_ONCE)
            .messageId(1)
            .retained(isRetained)
            .payload(Unpooled.wrappedBuffer(payload))
            .build());
  }

  private static HealthReport health(String name, ServiceStatus status) {
    return frozen(new HealthReport().serviceName(name).status(status));
  }

  private static boolean reports(PacketRules from, String name) {
    return publishes(from, Channels.HEALTH, health(name, ServiceStatus.RUNNING));
  }

  @Test
  void refusalOf_nameOfAnother_isRefusedUntilTheOtherLeaves() {
    assertThat(reports(first, "Lidar")).isTrue();
    assertThat(reports(second, "Lidar")).isFalse();
    assertThat(reports(second, "Sonar")).as("another name").isTrue();
    assertThat(reports(first, "Lidar")).as("still its own").isTrue();

    first.leave();

    assertThat(reports(second, "Lidar")).isTrue();
    assertThat(reports(first, "Lidar")).isFalse();
  }

  @Test
  void refusalOf_answersUnderTheNameOfAnother_areRefused() {
    reports(first, "Lidar");

    assertThat(
            publishes(
                second,
                Channels.DISCOVERY,
                frozen(
                    new DiscoveryResponse()
                        .serviceName("Lidar")
                        .serviceType("Sensor")
                        .status(ServiceStatus.RUNNING)
                        .host("there"))))
        .isFalse();
    assertThat(
            publishes(
                second,
                Channels.FUNCTIONALITY,
                frozen(new FunctionalityRequest().serviceName("Lidar"))))
        .as("a question, which names whom it asks")
        .isTrue();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "u2sa/cessna/navigation/NavigationPoint",
        "u2sa/cessna/plans/PlannedPath",
        "u2sa/cessna/plans/PlannedPath/=GIMBAL"
      })
  void refusalOf_nameLeftOut_isTheDefaultThatReadersTake(String topic) {
    U2SAData named =
        topic.contains("navigation")
            ? new NavigationPoint().subsystem("VEHICLE").point(Point.of(1.0, 0.0, 0.0))
            : new PlannedPath().subsystem("VEHICLE").planner("A").status(PathStatus.FOLLOWED);
    Channel<?> channel = topic.contains("navigation") ? Channels.NAVIGATION : Channels.PLANS;
    assertThat(publishes(first, channel, frozen(named))).isTrue();

    byte[] nameless = {(byte) 0xA0}; // the broker reads no more than the name

    assertThat(refusal(second, topic, nameless, false)).contains(SourceNames.TAKEN);
    assertThat(refusal(first, topic, nameless, false)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"state", "local-state"})
  void refusalOf_stateOfASecondEstimator_isRefusedWhateverItsName(String name) {
    Channel<?> channel = Channels.named(name).orElseThrow();
    StateInformation one = frozen(new StateInformation().sensorName("StateEstimator").x(1.0));
    StateInformation other = frozen(new StateInformation().sensorName("Impostor").x(1.0));
    assertThat(publishes(first, channel, one)).isTrue();
    assertThat(publishes(second, channel, other)).isFalse();

    pipeline.broker.sources.join(bus);
    bus.connect("StateEstimator", new RecordingReceiver()).publish(channel, one);

    assertThat(publishes(first, channel, other)).as("the vehicle has an estimator").isFalse();
  }

  @Test
  void refusalOf_deletionOfARetainedMessage_isOfTheTopicsSource() {
    PlannedPath path = new PlannedPath().planner("A").status(PathStatus.FOLLOWED);
    publishes(first, Channels.PLANS, frozen(path.subsystem("GIMBAL")));
    String topic = "u2sa/cessna/plans/PlannedPath/=GIMBAL";

    assertThat(refusal(second, topic, new byte[0], true)).contains(SourceNames.TAKEN);
    assertThat(refusal(first, topic, new byte[0], true)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void refusalOf_sensorActuatorOrOnlyWriterOfAnother_isRefused(boolean isCompact) {
    WireForm form = isCompact ? WireForm.COMPACT : WireForm.READABLE;
    StateInformation gps = frozen(new StateInformation().sensorName("gps").x(1.0));
    ActuatorAnnouncement rudder =
        frozen(new ActuatorAnnouncement().actuatorName("RUDDER").minimum(-1.0).maximum(1.0));
    ArmingState armed = frozen(new ArmingState().armed(true));
    assertThat(publishes(first, Channels.SENSED_STATE, gps, form)).isTrue();
    assertThat(publishes(first, Channels.ACTUATORS, rudder, form)).isTrue();
    assertThat(publishes(first, Channels.ARMING_STATE, armed, form)).isTrue();

    assertThat(publishes(second, Channels.SENSED_STATE, gps, form)).isFalse();
    assertThat(publishes(second, Channels.ACTUATORS, rudder, form)).isFalse();
    assertThat(publishes(second, Channels.ARMING_STATE, armed, form)).isFalse();
    assertThat(publishes(second, Channels.STATE, gps, form)).as("another channel").isTrue();
    StateInformation imu = frozen(new StateInformation().sensorName("imu").x(1.0));
    assertThat(publishes(second, Channels.SENSED_STATE, imu, form)).isTrue();
  }

  @Test
  void refusalOf_nothingToBeRetainedInPlaceOfAnothersMessage_isRefused() {
    String topic = "u2sa/cessna/actuators/ActuatorAnnouncement";
    ActuatorAnnouncement rudder =
        frozen(new ActuatorAnnouncement().actuatorName("RUDDER").minimum(-1.0).maximum(1.0));
    assertThat(publishes(first, Channels.ACTUATORS, rudder)).isTrue();

    assertThat(refusal(second, topic + "/=RUDDER", new byte[0], true))
        .contains("its source name belongs to another connection");
    assertThat(refusal(second, topic + "/=FLAPS", rudder.serialize(), false))
        .as("what readers read counts")
        .contains("its source name belongs to another connection");
    assertThat(refusal(first, topic + "/=RUDDER", new byte[0], true)).isEmpty();
  }

  @Test
  void refusalOf_sameNameInAnotherSystem_isAnotherName() {
    reports(first, "Lidar");
    HealthReport other = new HealthReport().serviceName("Lidar").status(ServiceStatus.RUNNING);
    other.systemId("boat");
    other.timestamp(1);
    other.freeze();

    assertThat(publishes(second, Channels.HEALTH, other)).isTrue();
  }

  @Test
  void refusalOf_sameClientAgain_whileItsOldConnectionIsHalfOpen_isTaken() {
    reports(first, "Lidar");
    PacketRules again = client("first");

    assertThat(reports(again, "Lidar")).isTrue();
    first.leave();
    assertThat(reports(second, "Lidar")).as("held by the newer connection").isFalse();
  }

  @Test
  void refusalOf_nameOfASilentConnection_isTakenOver() {
    reports(first, "Lidar");
    pipeline.passSeconds(5);
    assertThat(reports(second, "Lidar")).isFalse();

    pipeline.pass(1);

    assertThat(reports(second, "Lidar")).isTrue();
    assertThat(reports(first, "Lidar")).as("it comes back too late").isFalse();
  }

  @Test
  void refusalOf_vehiclesService_takesItsNameFromWhoeverUsedItBefore() {
    assertThat(reports(first, "PathPlanner")).isTrue();

    assertThat(reports(ofVehicle, "PathPlanner")).isTrue();
    assertThat(reports(first, "PathPlanner")).isFalse();
  }

  @Test
  void refusalOf_nameOfAVehiclesServiceThatFailed_isKeptForItsSuccessor() {
    reports(ofVehicle, "PathPlanner");
    ofVehicle.leave(); // killed
    pipeline.passSeconds(60);
    assertThat(reports(first, "PathPlanner")).isFalse();

    PacketRules successor = client(ClientIds.of("cessna", "PathPlanner"));

    assertThat(reports(successor, "PathPlanner")).isTrue();
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void refusalOf_armedStateWhileTheVehiclesSafetyManagerRestarts_isRefused(boolean isLocal) {
    pipeline.broker.sources.join(bus);
    ArmingState armed = frozen(new ArmingState().armed(true));
    if (isLocal) {
      pipeline.broker.sources.hearLocal(Channels.ARMING_STATE, armed);
    } else {
      assertThat(publishes(ofVehicle, Channels.ARMING_STATE, armed)).isTrue();
      ofVehicle.leave();
    }

    assertThat(publishes(first, Channels.ARMING_STATE, armed)).isFalse();
  }

  @Test
  void refusalOf_nameOfAVehiclesServiceThatStopped_isFree() {
    reports(ofVehicle, "PathPlanner");
    publishes(ofVehicle, Channels.HEALTH, health("PathPlanner", ServiceStatus.STOPPED));
    ofVehicle.leave();

    assertThat(reports(first, "PathPlanner")).isTrue();
  }

  @Test
  void refusalOf_nameOfAServiceOfTheBrokersProcess_isRefusedFromItsFirstReportToItsLast() {
    pipeline.broker.sources.join(bus);
    reports(first, "PathPlanner");

    pipeline.broker.sources.hearLocal(
        Channels.HEALTH, health("PathPlanner", ServiceStatus.RUNNING));
    assertThat(reports(first, "PathPlanner")).isFalse();
    pipeline.broker.sources.hearLocal(Channels.HEALTH, health("PathPlanner", ServiceStatus.FAILED));
    assertThat(reports(first, "PathPlanner")).isFalse();
    pipeline.broker.sources.hearLocal(
        Channels.HEALTH, health("PathPlanner", ServiceStatus.STOPPED));

    assertThat(reports(first, "PathPlanner")).isTrue();
  }

  @Test
  void refusalOf_sourceOfTheBrokersProcess_isRefusedWhileItsServiceIsConnected() {
    pipeline.broker.sources.join(bus);
    StateInformation gps = frozen(new StateInformation().sensorName("gps").x(1.0));
    var local = bus.connect("Gps", new RecordingReceiver());
    local.publish(Channels.SENSED_STATE, gps);
    assertThat(publishes(first, Channels.SENSED_STATE, gps)).isFalse();

    local.close();

    assertThat(publishes(first, Channels.SENSED_STATE, gps)).isTrue();
  }

  private static FailsafeState failsafe() {
    return frozen(new FailsafeState().action(FailsafeAction.HOLD));
  }

  private static ArmingState armed() {
    return frozen(new ArmingState().armed(true));
  }

  private static ServiceCondition condition() {
    return frozen(new ServiceCondition().serviceName("SafetyManager").condition(Condition.LOST));
  }

  @Test
  void refusalOf_failsafeOfManagerAndMonitorInTwoOtherRuns_areAccepted() {
    PacketRules manager = first;
    PacketRules monitor = second;
    assertThat(publishes(manager, Channels.FAILSAFE, failsafe())).isTrue();
    publishes(manager, Channels.ARMING_STATE, armed());
    assertThat(publishes(monitor, Channels.FAILSAFE, failsafe())).as("no monitor yet").isFalse();

    publishes(monitor, Channels.CONDITIONS, condition());
    assertThat(publishes(monitor, Channels.FAILSAFE, failsafe())).isTrue();
    manager.leave();
    assertThat(publishes(monitor, Channels.FAILSAFE, failsafe())).isTrue();

    PacketRules restarted = client("third");
    assertThat(publishes(restarted, Channels.FAILSAFE, failsafe())).isTrue();
    assertThat(publishes(restarted, Channels.ARMING_STATE, armed())).isTrue();
    assertThat(publishes(monitor, Channels.FAILSAFE, failsafe())).isTrue();
    assertThat(publishes(client("fourth"), Channels.FAILSAFE, failsafe())).isFalse();
  }

  @Test
  void refusalOf_failsafeOfAManagerInAnotherRunThanTheVehiclesMonitor_isAccepted() {
    pipeline.broker.sources.join(bus);
    PacketRules manager = first;
    publishes(manager, Channels.ARMING_STATE, armed());
    var monitor = bus.connect("HealthMonitor", new RecordingReceiver());
    monitor.publish(Channels.FAILSAFE, failsafe());
    pipeline.broker.sources.hearLocal(Channels.CONDITIONS, condition());
    pipeline.broker.sources.hearLocal(Channels.FAILSAFE, failsafe());

    assertThat(publishes(manager, Channels.FAILSAFE, failsafe())).isTrue();
    publishes(second, Channels.CONDITIONS, condition());
    assertThat(publishes(second, Channels.FAILSAFE, failsafe())).as("a third run").isFalse();
  }

  @Test
  void refusalOf_failsafeOfAMonitorInAnotherRunThanTheVehiclesManager_isAccepted() {
    pipeline.broker.sources.join(bus);
    pipeline.broker.sources.hearLocal(Channels.ARMING_STATE, armed());
    pipeline.broker.sources.hearLocal(Channels.FAILSAFE, failsafe());
    PacketRules monitor = first;
    publishes(monitor, Channels.CONDITIONS, condition());
    assertThat(publishes(monitor, Channels.FAILSAFE, failsafe())).isTrue();

    monitor.leave();
    PacketRules again = client("first");
    assertThat(publishes(again, Channels.FAILSAFE, failsafe())).as("connected again").isTrue();
    publishes(second, Channels.CONDITIONS, condition());
    assertThat(publishes(second, Channels.FAILSAFE, failsafe())).as("a third run").isFalse();
    assertThat(publishes(ofVehicle, Channels.FAILSAFE, failsafe())).isTrue();
  }

  @Test
  void refusalOf_failsafeOfAnother_besideManagerAndMonitorOfTheVehicle_isRefusedForGood() {
    assertThat(publishes(ofVehicle, Channels.ARMING_STATE, armed())).isTrue();
    assertThat(publishes(ofVehicle, Channels.CONDITIONS, condition())).isTrue();
    ofVehicle.leave();
    pipeline.passSeconds(60);

    publishes(first, Channels.CONDITIONS, condition());

    assertThat(publishes(first, Channels.FAILSAFE, failsafe())).isFalse();
  }
}
