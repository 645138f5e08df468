package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.access.LocalAccount;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.testkit.FreePort;

/** How many clients are admitted, of whom, and what the first one too many is told. */
class ConnectionLimitsTest {
  private static final int MOST = 16; // so eight of one user, and one kept free for operators
  private static final String ACCEPTED = "accepted";
  private static final String COME_AGAIN = "20 3";
  private static final String WRONG_ID = "20 2";

  private final LocalAccount account = LocalAccount.at("127.0.0.1", FreePort.find(), line -> {});
  private final Users users = new Users(account);
  private final List<PacketPipeline> clients = new ArrayList<>();

  @AfterEach
  void close() {
    clients.forEach(PacketPipeline::close);
    account.close();
  }

  private void addUser(String name, AccessRole role) {
    PasswordHash hash = PasswordHash.of(name.toCharArray(), new SecureRandom(), 1_000);
    users.add(new User(name, EnumSet.of(role), List.of(User.EVERY_SYSTEM), hash));
  }

  private PacketPipeline client(Users known) {
    PacketPipeline client =
        clients.isEmpty()
            ? new PacketPipeline(Map.of("MAX CLIENTS", MOST), known)
            : new PacketPipeline(clients.get(0));
    clients.add(client);
    return client;
  }

  private static String answer(PacketPipeline client) {
    return client.taken().contains("CONNECT") ? ACCEPTED : client.sent().get(0);
  }

  /** What a user's client is told; its password is the user's name. */
  private String connect(String user, String clientId) {
    PacketPipeline client = client(users);
    client.send(MqttPacketBytes.connectAs(user, user, clientId));
    return answer(client);
  }

  private void assertRefusedFor(String reason) {
    assertThat(clients.get(0).log).anyMatch(line -> line.startsWith("log-in refused, " + reason));
  }

  @Test
  void connect_oneOfAUserTooMany_isRefusedButNotOneInPlaceOfAnother() {
    addUser("ann", AccessRole.SERVICE);
    for (int i = 0; i < MOST / 2; i++) {
      assertThat(connect("ann", "a" + i)).isEqualTo(ACCEPTED);
    }
    assertThat(connect("ann", "one more")).isEqualTo(COME_AGAIN);
    assertRefusedFor("too many connections of one user");

    assertThat(connect("ann", "a3")).isEqualTo(ACCEPTED);
    assertThat(connect("ann", "one more")).isEqualTo(COME_AGAIN);
  }

  @Test
  void connect_oneTooMany_isRefusedAndOneIsKeptFreeForAnOperator() {
    addUser("ann", AccessRole.SERVICE);
    addUser("bob", AccessRole.OBSERVER);
    addUser("pilot", AccessRole.OPERATOR);
    for (int i = 0; i < MOST / 2; i++) {
      assertThat(connect("ann", "a" + i)).isEqualTo(ACCEPTED);
    }
    for (int i = 1; i < MOST / 2; i++) {
      assertThat(connect("bob", "b" + i)).isEqualTo(ACCEPTED);
    }
    assertThat(connect("bob", "one more")).isEqualTo(COME_AGAIN);
    assertRefusedFor("too many connections:");
    assertThat(connect("bob", "b3")).as("in place of another").isEqualTo(ACCEPTED);

    assertThat(connect("pilot", "p1")).isEqualTo(ACCEPTED);
    assertThat(connect("pilot", "p2")).isEqualTo(COME_AGAIN);
    assertThat(connect("pilot", "p1")).isEqualTo(ACCEPTED);
  }

  @Test
  void connect_withoutUsers_asManyAsThereMayBe() {
    for (int i = 0; i < MOST; i++) {
      PacketPipeline client = client(null);
      client.send(MqttPacketBytes.connect("c" + i, 0));
      assertThat(answer(client)).isEqualTo(ACCEPTED);
    }
    PacketPipeline tooMany = client(null);
    tooMany.send(MqttPacketBytes.connect("one more", 0));
    assertThat(answer(tooMany)).isEqualTo(COME_AGAIN);

    clients.get(3).close();
    PacketPipeline next = client(null);
    next.send(MqttPacketBytes.connect("one more", 0));
    assertThat(answer(next)).isEqualTo(ACCEPTED);
  }

  @Test
  void connect_idOfAnotherUsersClient_isRefusedAndTheFirstStays() {
    addUser("ann", AccessRole.SERVICE);
    addUser("bob", AccessRole.SERVICE);
    assertThat(connect("ann", "x")).isEqualTo(ACCEPTED);
    assertThat(connect("bob", "x")).isEqualTo(WRONG_ID);
    assertRefusedFor("the client ID belongs to another user");

    assertThat(clients.get(0).channel.isOpen()).isTrue();
  }

  @Test
  void connect_sameClientAgain_endsTheOlderConnectionWithoutItsWill() {
    PacketPipeline listener = client(null);
    listener.introduced();
    listener.send(MqttPacketBytes.subscribe("u2sa/#"));
    listener.sent();
    PacketPipeline first = client(null);
    first.send(MqttPacketBytes.connect("x", 1));
    PacketPipeline second = client(null);
    second.send(MqttPacketBytes.connect("x", 1));
    first.pass(1);

    assertThat(first.channel.isOpen()).isFalse();
    assertThat(second.channel.isOpen()).isTrue();
    assertThat(listener.sent()).isEmpty();
  }

  @Test
  void connect_wrongToken_isRefused() {
    addUser("ann", AccessRole.SERVICE);
    PacketPipeline client = client(users);
    client.send(MqttPacketBytes.connectAs("ann", "bob", "x"));

    assertThat(answer(client)).isEqualTo("20 4");
    assertRefusedFor("wrong token");
    assertThat(client.channel.isOpen()).isFalse();
  }
}
