package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import java.security.GeneralSecurityException;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;

/** What one who may only look tries on a vehicle. */
@Timeout(120)
class ObserverAttackTest extends SecuredClients {
  private static final int FORBIDDEN_USER_GETS_IN = 0;
  private static final byte[] STOP = new StopCommand().stopAll(true).serialize();
  private static final byte[] CLEAR =
      new EmergencyStop().active(false).clears(1L << 62).serialize();
  private static final byte[] ARM =
      new ArmCommand().arm(true).requestId("1").operator("x").serialize();
  private static final byte[] CHANGE =
      new ConfigurationTransaction()
          .requestId("1")
          .serviceName("Control")
          .assignments(List.of())
          .serialize();

  private record Attempt(String topic, byte[] payload) {}

  private static final List<Attempt> ATTEMPTS =
      List.of(
          new Attempt("configuration/ConfigurationRequest/ConfigurationTransaction", CHANGE),
          new Attempt("configuration/ConfigurationRequest/EmergencyStop", CLEAR),
          new Attempt("configuration/ConfigurationRequest/ArmCommand", ARM),
          new Attempt("discovery/DiscoveryRequest/StopCommand", STOP),
          new Attempt("discovery/DiscoveryRequest/Tide/StopCommand", STOP),
          new Attempt("discovery/StopCommand", STOP),
          new Attempt("stop/StopCommand", STOP),
          new Attempt("stop/DiscoveryRequest/StopCommand", STOP),
          new Attempt("my-own/StopCommand", STOP),
          new Attempt("arming/ArmCommand", ARM),
          new Attempt("emergency-stop/EmergencyStop", CLEAR),
          new Attempt("emergency-stop/EmergencyStop", new byte[0]));

  private RawClient client() throws IOException, GeneralSecurityException {
    return new RawClient(TestAuthority.socket(directory), broker.port);
  }

  /** A client that logs in at once: the broker waits for that for seconds only. */
  private RawClient loggedIn(String user) throws IOException, GeneralSecurityException {
    RawClient client = client();
    assertThat(client.introduce(user, user, user)).isZero();
    return client;
  }

  /** A question that comes later than what was tried: when it is there, so would the others be. */
  private void awaitQuestion(RawClient screen) throws IOException {
    U2SAData question = new DiscoveryRequest();
    screen.publish("u2sa/cessna/discovery/DiscoveryRequest", question.serialize(), 1);
    soon().until(() -> inbox.messages.stream().anyMatch(DiscoveryRequest.class::isInstance));
  }

  private long refusals() {
    return broker.log.stream()
        .filter(line -> line.startsWith("message refused, ") && line.contains("\"screen\""))
        .count();
  }

  @Test
  void publish_commandsInAnyDisguise_noneArrivesAndEachKindIsLogged()
      throws IOException, GeneralSecurityException {
    try (RawClient screen = client()) {
      assertThat(screen.introduce("screen", "screen", "screen")).isZero();
      for (Attempt attempt : ATTEMPTS) {
        screen.publish("u2sa/cessna/" + attempt.topic, attempt.payload, 1);
        screen.publish("u2sa/cessna/" + attempt.topic, attempt.payload, 0);
        screen.publishRetained("u2sa/cessna/" + attempt.topic, attempt.payload);
      }
      awaitQuestion(screen);
    }
    assertThat(inbox.messages).allMatch(DiscoveryRequest.class::isInstance);
    assertThat(refusals()).isGreaterThan(5);
    awaitLog("message refused, its types are not a class and its ancestors", "\"screen\"");
    awaitLog("message refused, discovery does not carry StopCommand", "\"screen\"");
    awaitLog("role observer may not publish on emergency-stop (EmergencyStop)");
  }

  @Test
  void will_commandsInAnyDisguise_noneIsSaid() throws IOException, GeneralSecurityException {
    for (boolean retained : new boolean[] {false, true}) {
      for (Attempt attempt : ATTEMPTS) {
        try (RawClient screen = client()) {
          screen.willing("u2sa/cessna/" + attempt.topic, attempt.payload, retained);
          assertThat(screen.introduce("will", "screen", "screen"))
              .isEqualTo(FORBIDDEN_USER_GETS_IN);
        } // breaks off without a word
      }
    }
    try (RawClient screen = client()) {
      assertThat(screen.introduce("screen", "screen", "screen")).isZero();
      awaitQuestion(screen);
    }
    assertThat(inbox.messages).allMatch(DiscoveryRequest.class::isInstance);
    awaitLog("will refused", "\"screen\"");
  }

  @Test
  void will_thatClearsAnEmergencyStop_isRefusedEvenToTheOperator()
      throws IOException, GeneralSecurityException {
    EmergencyStop set = frozen(new EmergencyStop().active(true).reason("dead man"));
    try (RawClient pilot = client()) {
      pilot.willing("u2sa/cessna/emergency-stop/EmergencyStop", CLEAR, false);
      assertThat(pilot.introduce("clearing", "pilot", "pilot")).isZero();
    }
    awaitLog("will refused, a will may not clear an emergency stop", "\"pilot\"");
    try (RawClient pilot = client()) {
      pilot.willing("u2sa/cessna/emergency-stop/EmergencyStop", set.serialize(), true);
      assertThat(pilot.introduce("stopping", "pilot", "pilot")).isZero();
    }
    soon().until(() -> inbox.messages.contains(set));
    assertThat(inbox.messages)
        .noneMatch(message -> message instanceof EmergencyStop stop && !stop.active());
  }

  @Test
  void publishRetained_byTheThousand_leavesRoomForTheEmergencyStop()
      throws IOException, GeneralSecurityException {
    try (RawClient screen = loggedIn("screen");
        RawClient sensor = loggedIn("sensor")) {
      byte[] question = new DiscoveryRequest().serialize();
      byte[] goals = new GoalList().serialize();
      for (int i = 0; i < 300; i++) {
        screen.publishRetained("u2sa/cessna/discovery/DiscoveryRequest/Tide" + i, question);
        sensor.publishRetained("u2sa/cessna/goals/GoalList/Tide" + i, goals);
        sensor.publishRetained("u2sa/cessna/own-" + i + "/Tide", new byte[] {(byte) 0xa0});
      }
      awaitLog("message refused, discovery retains nothing", "\"screen\"");
      awaitLog("message refused, too many retained topics", "\"sensor\"");
    }
    EmergencyStop stop = frozen(new EmergencyStop().active(true));
    Connection pilot = connect("pilot");
    pilot.publish(Channels.EMERGENCY_STOP, stop);
    soon().until(() -> inbox.messages.contains(stop));

    RecordingReceiver late = new RecordingReceiver();
    connect("screen", late).subscribe(Channels.EMERGENCY_STOP);
    soon().until(() -> late.messages.contains(stop));
  }

  @Override
  Map<String, Object> variables() {
    return Map.of("MAX RETAINED TOPICS", 64);
  }
}
