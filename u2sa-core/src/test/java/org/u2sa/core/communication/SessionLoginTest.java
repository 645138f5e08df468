package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.Unpooled;
import java.io.ByteArrayOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.communication.routing.Publication;
import org.u2sa.core.communication.routing.TopicRoute;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;

/** How a client with a password is admitted, what it may hear, and when it has to go again. */
class SessionLoginTest {
  private static final String PASSWORD = "right";
  private static final String COME_AGAIN = "20 3";
  private static final String WRONG_PASSWORD = "20 4";
  private static final String NOT_AUTHORIZED = "20 5";

  @TempDir Path folder;
  private Path file;
  private PacketPipeline client;

  @BeforeEach
  void connect() {
    file = folder.resolve("users.txt");
    connect(1_000);
  }

  private void connect(int iterations) {
    write(AccessRole.OPERATOR, iterations);
    client = new PacketPipeline(Map.of(), new Users(file, line -> {}));
  }

  @AfterEach
  void close() {
    client.close();
    client.filter.close();
  }

  private void write(AccessRole role) {
    write(role, 1_000);
  }

  private void write(AccessRole role, int iterations) {
    PasswordHash hash = PasswordHash.of(PASSWORD.toCharArray(), new SecureRandom(), iterations);
    UserFile.write(file, List.of(new User("ann", EnumSet.of(role), List.of("cessna"), hash)));
  }

  private static void until(PacketPipeline client, BooleanSupplier condition) {
    BrokerTraffic.soon()
        .until(
            () -> {
              client.channel.runPendingTasks();
              return condition.getAsBoolean();
            });
  }

  private void assertAnswered(PacketPipeline client, String answer) {
    until(client, () -> !client.channel.isOpen());
    assertThat(client.sent()).containsExactly(answer);
    assertThat(client.taken()).isEmpty();
  }

  private void assertRefusedFor(String reason) {
    assertThat(client.log).anyMatch(line -> line.startsWith("log-in refused, " + reason + ":"));
  }

  private void logIn() {
    client.send(MqttPacketBytes.connectAs("ann", PASSWORD, "hers"));
    until(client, () -> !client.session.isPending() && client.taken().contains("CONNECT"));
    client.broker.clients.connected(client.session.connection());
    client.pass(2);
  }

  @Test
  void connect_rightPassword_isAdmittedAsItsUser() {
    assertThat(client.session.isPending()).isTrue();
    assertThat(client.session.isOperator()).isFalse();
    logIn();

    assertThat(client.session.name()).isEqualTo("ann");
    assertThat(client.session.isOperator()).isTrue();
    assertThat(client.sent()).as("it is Moquette that answers").isEmpty();
  }

  @Test
  void connect_furtherPacketsWithTheFirst_waitUntilItIsAdmitted() {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.writeBytes(MqttPacketBytes.connectAs("ann", PASSWORD, "hers"));
    bytes.writeBytes(MqttPacketBytes.subscribe("u2sa/cessna/#"));
    client.send(bytes.toByteArray());
    until(client, () -> client.taken().contains("CONNECT"));
    client.pass(10);
    assertThat(client.sent()).as("Moquette has not answered yet").isEmpty();

    client.broker.clients.connected(client.session.connection());
    client.pass(10);
    assertThat(client.sent()).containsExactly("90");
  }

  @Test
  void connect_wrongPassword_isRefusedAndTheNextOneTooSoon() {
    client.send(MqttPacketBytes.connectAs("ann", "wrong", "hers"));
    assertAnswered(client, WRONG_PASSWORD);
    assertRefusedFor("wrong password");

    PacketPipeline again = new PacketPipeline(client);
    again.send(MqttPacketBytes.connectAs("ann", PASSWORD, "hers"));
    assertAnswered(again, COME_AGAIN);
    assertRefusedFor("too soon after a wrong password");
  }

  @Test
  void connect_nobody_isRefused() {
    client.send(MqttPacketBytes.connect("client", 0));
    assertAnswered(client, NOT_AUTHORIZED);
    assertRefusedFor("it gives no user name");
  }

  @Test
  void connect_willOfAnotherSystem_isRefused() {
    client.send(
        MqttPacketBytes.connectAs("ann", PASSWORD, "hers", "u2sa/boat/health/HealthReport"));
    assertAnswered(client, NOT_AUTHORIZED);
    assertRefusedFor("it belongs to another system");
  }

  @Test
  void connect_willThatItMayNotHave_isAdmittedWithoutIt() {
    client.send(MqttPacketBytes.connectAs("ann", PASSWORD, "hers", "u2sa/cessna/stop/StopCommand"));
    until(client, () -> client.taken().contains("CONNECT"));
    assertThat(client.log)
        .anyMatch(line -> line.startsWith("will refused, StopCommand is not a will"));
  }

  @Test
  void connect_goneBeforeTheAnswer_isNeitherAdmittedNorLogged() {
    close();
    connect(300_000); // slower than the client goes
    client.send(MqttPacketBytes.connectAs("ann", PASSWORD, "hers"));
    client.channel.close();
    PacketPipeline next = new PacketPipeline(client);
    next.send(MqttPacketBytes.connectAs("ann", PASSWORD, "next"));
    until(next, () -> next.taken().contains("CONNECT")); // passwords are checked in order
    client.channel.runPendingTasks();

    assertThat(client.taken()).isEmpty();
    assertThat(client.log).isEmpty();
    next.close();
  }

  @Test
  void look_userUnchanged_stays() {
    logIn();
    client.filter.tidy();
    client.passSeconds(20);
    assertThat(client.channel.isOpen()).isTrue();
  }

  @Test
  void look_userChanged_isPutOut() throws Exception {
    logIn();
    write(AccessRole.OBSERVER);
    Files.setLastModifiedTime(file, FileTime.fromMillis(1_000));
    client.filter.tidy();
    until(
        client,
        () -> {
          client.passSeconds(1);
          return !client.channel.isOpen();
        });

    assertThat(client.log)
        .anyMatch(line -> line.startsWith("client disconnected, its user was changed or removed:"));
  }

  /** A pipe that nobody writes to keeps its reader waiting. */
  @Test
  @Timeout(120)
  @EnabledOnOs(OS.LINUX)
  void look_diskHangs_doesNotWaitAndKnownUsersLogIn() throws Exception {
    Files.delete(file);
    assertThat(new ProcessBuilder("mkfifo", "-m", "600", file.toString()).start().waitFor())
        .isZero();
    client.filter.tidy();
    client.filter.tidy();
    logIn();

    assertThat(client.channel.isOpen()).isTrue();
    Files.newOutputStream(file).close(); // waits for the reader, and lets it go on
  }

  @Test
  void deliver_topicsOfOtherSystems_areNotSent() {
    logIn();
    deliver("u2sa/boat/tide/Tide");
    deliver("other/cessna/tide/Tide");
    deliver("u2sa/cessna");
    deliver("u2sa/cessna2/tide/Tide");
    assertThat(client.sentPackets()).isZero();

    deliver("u2sa/cessna/tide/Tide");
    deliver("u2sa/cessna/wind/Wind");
    assertThat(client.sentPackets()).isEqualTo(2);
    deliver("u2sa/boat/tide/Tide");
    deliver("u2sa/cessna2/tide/Tide");
    assertThat(client.sentPackets()).isZero();
  }

  private void deliver(String topic) {
    Publication message =
        new Publication(new TopicRoute(topic), Unpooled.wrappedBuffer(new byte[1]), false);
    client.session.deliver(message, false);
    client.channel.runPendingTasks();
    message.release();
  }

  @Test
  void publish_longEmergencyStopOfAnOperator_waitsForNobodysLongMessages() {
    logIn();
    client.broker.costlyTime.take(this, 10.0, 0); // [s], of others

    client.send(MqttPacketBytes.publish("u2sa/cessna/emergency-stop/EmergencyStop", 4_000, 7));

    assertThat(client.sent()).as("acknowledged").containsExactly("40");
  }

  @Test
  void publish_longMessageOfAService_waitsForTheTimeThatOthersTook() {
    write(AccessRole.SERVICE);
    client.close();
    client = new PacketPipeline(Map.of(), new Users(file, line -> {}));
    logIn();
    client.broker.costlyTime.take(this, 1.0, 0); // [s]

    client.send(MqttPacketBytes.publish("u2sa/cessna/goals/GoalList", 4_000, 7));
    passWhileAnotherAsks(1_900);
    assertThat(client.sent()).isEmpty();
    passWhileAnotherAsks(200);
    assertThat(client.sent()).as("half of the time is theirs").containsExactly("40");
  }

  @Test
  void publish_longMessageOfTheOnlyOneWhoSendsThem_waitsForNoShare() {
    write(AccessRole.SERVICE);
    client.close();
    client = new PacketPipeline(Map.of(), new Users(file, line -> {}));
    logIn();
    client.broker.costlyTime.take(this, 1.0, 0); // [s]

    client.send(MqttPacketBytes.publish("u2sa/cessna/goals/GoalList", 4_000, 7));
    client.pass(110);

    assertThat(client.sent()).containsExactly("40");
  }

  @Test
  void channelRead_partOfALongMessageWhileOthersSendThem_isReadNoFurther() {
    write(AccessRole.SERVICE);
    client.close();
    client = new PacketPipeline(Map.of(), new Users(file, line -> {}));
    logIn();
    client.broker.costlyTime.take(this, 0.1, 0); // [s]

    client.send(
        Arrays.copyOf(MqttPacketBytes.publish("u2sa/cessna/goals/GoalList", 9_000, 7), 5_000));

    assertThat(client.channel.config().isAutoRead()).isFalse();
    passWhileAnotherAsks(170);
    assertThat(client.channel.config().isAutoRead()).isFalse();
    passWhileAnotherAsks(50);
    assertThat(client.channel.config().isAutoRead()).isTrue();
  }

  /** Another client waits with long messages meanwhile. */
  private void passWhileAnotherAsks(int millis) {
    for (int i = 0; i < millis; i += 10) {
      client.broker.costlyTime.isOpen(this, client.broker.nowMicros());
      client.pass(10);
    }
  }
}
