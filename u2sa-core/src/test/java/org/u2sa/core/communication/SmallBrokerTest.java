package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.u2sa.messages.safety.EmergencyStop;

/** Floods against a broker with 48 MB of heap, or with few file descriptors. */
@Tag("long")
@Timeout(300)
@EnabledOnOs(OS.LINUX)
class SmallBrokerTest {
  private static final String STOP = "u2sa/cessna/emergency-stop/EmergencyStop";
  private static final int MANY = 4_096;

  private final List<RawClient> clients = new ArrayList<>();
  private final AtomicBoolean isOver = new AtomicBoolean();
  private final List<Thread> floods = new ArrayList<>();
  private SmallBroker broker;

  @AfterEach
  void close() throws IOException {
    isOver.set(true);
    leave();
    broker.close();
  }

  private void leave() throws IOException {
    for (RawClient client : clients) {
      client.close();
    }
    clients.clear();
  }

  private RawClient client(String name) throws IOException {
    RawClient client = new RawClient(broker.port);
    clients.add(client);
    return client.introduced(name);
  }

  private interface Attack {
    void run(RawClient client) throws IOException;
  }

  /** Runs an attack again and again on a thread of its own, until it is put out. */
  private void flood(String name, Attack attack) throws IOException {
    RawClient client = client(name);
    Thread thread =
        new Thread(
            () -> {
              try {
                while (!isOver.get()) {
                  attack.run(client);
                }
              } catch (IOException e) {
                isOver.get(); // put out: the attack has ended
              }
            },
            name);
    thread.setDaemon(true);
    thread.start();
    floods.add(thread);
  }

  /** A pilot's stop reaches a screen that both come now. */
  private void assertStopArrives() throws IOException {
    try (RawClient screen = new RawClient(broker.port).introduced("screen");
        RawClient pilot = new RawClient(broker.port).introduced("pilot")) {
      assertThat(screen.subscribe("u2sa/cessna/emergency-stop/#", 1)).isEqualTo(1);
      EmergencyStop stop = BrokerTraffic.frozen(new EmergencyStop().active(true));
      pilot.publish(STOP, stop.serialize(), 1);
      assertThat(pilot.next()).isEqualTo(0x40);
      assertThat(screen.nextMessage()).isPositive();
    }
  }

  @Test
  void floodsOfEveryKind_with48Megabytes_theStopArrivesAndNothingRunsOut() throws IOException {
    broker = new SmallBroker(MANY, "48m");
    byte[] unfinished = MqttPacketBytes.publish(AttackedBroker.STATE, 1_000_000);
    for (int i = 0; i < 100; i++) {
      RawClient client = client("unfinished-" + i);
      try {
        client.send(Arrays.copyOf(unfinished, unfinished.length - 1));
      } catch (IOException e) {
        continue; // put out
      }
    }
    assertStopArrives();
    for (int i = 0; i < 30; i++) {
      client("deaf-" + i).send(MqttPacketBytes.subscribeToEach("u2sa/#"));
      client("mute-" + i).send(MqttPacketBytes.subscribe("u2sa/#"));
    }
    byte[] pings = new byte[16_384];
    for (int i = 0; i < pings.length; i += 2) {
      pings[i] = (byte) 0xc0;
    }
    for (int i = 0; i < 10; i++) {
      flood("pings-" + i, client -> client.send(pings));
      flood("large-" + i, client -> client.publish(AttackedBroker.STATE, new byte[100_000], 1));
      flood("small-" + i, client -> client.publish(AttackedBroker.STATE, new byte[1], 1));
    }
    for (int i = 0; i < 60; i++) {
      RawClient retaining = client("retaining-" + i);
      for (int j = 0; j < 20; j++) {
        byte[] map = new byte[100_000];
        map[0] = (byte) 0xa1; // {"x": 99,990 bytes}
        map[1] = 0x61;
        map[2] = 'x';
        map[3] = 0x5a;
        map[5] = 1;
        map[6] = (byte) 0x86;
        map[7] = (byte) 0x98; // 0x00018698
        try {
          retaining.publishRetained("u2sa/cessna/own-" + i + "/Tide" + j, map);
        } catch (IOException e) {
          break; // put out
        }
      }
    }
    for (int i = 0; i < 10; i++) {
      assertStopArrives();
    }
    isOver.set(true);
    leave();
    assertStopArrives();
    String output = broker.output();
    System.out.println(output);
    assertThat(output).doesNotContain("OutOfMemory").doesNotContain("the broker failed");
  }

  @Test
  void recordsOfInventedHosts_byMulticastDns_with48Megabytes_takeNoMemory() throws IOException {
    broker = new SmallBroker(MANY, "48m");
    InetAddress group = InetAddress.getByName("224.0.0.251");
    try (MulticastSocket socket = new MulticastSocket()) {
      socket.setNetworkInterface(
          NetworkInterface.getByInetAddress(InetAddress.getLoopbackAddress()));
      for (int i = 0; i < 60_000; i++) {
        byte[] records = addresses(i);
        socket.send(new DatagramPacket(records, records.length, group, 5353));
        if (i % 100 == 0) {
          assertStopArrives(); // and the broker's thread for them has time to read them
        }
      }
    }

    String output = broker.output();
    System.out.println(output);
    assertThat(output).doesNotContain("OutOfMemory");
  }

  /** A message of multicast DNS with addresses of hosts that nobody has heard of. */
  private static byte[] addresses(int number) {
    int most = 40;
    ByteBuffer out = ByteBuffer.allocate(1_400);
    out.putShort((short) 0).putShort((short) 0x8400); // a response
    out.putShort((short) 0).putShort((short) most).putInt(0);
    for (int i = 0; i < most; i++) {
      byte[] host = String.format("host%010d", number * most + i).getBytes(StandardCharsets.UTF_8);
      out.put((byte) host.length).put(host).put((byte) 0);
      out.putShort((short) 1).putShort((short) 1).putInt(4_500).putShort((short) 4).putInt(i);
    }
    return Arrays.copyOf(out.array(), out.position());
  }

  /** Each address may have 32 pending connections. */
  private static Socket socketFrom(String address) throws IOException {
    Socket socket = new Socket();
    socket.bind(new InetSocketAddress(address, 0));
    return socket;
  }

  @Test
  void fileDescriptors_allTaken_theBrokerAcceptsAgainWhenSomeAreFree() throws IOException {
    broker = new SmallBroker(160, "256m");
    for (int i = 0; i < 200; i++) { // the kernel accepts what the broker cannot
      clients.add(new RawClient(socketFrom("127.0.0." + (1 + i / 50)), broker.port));
    }
    assertThat(clients.get(0).isPutOut()).as("the oldest gives way").isTrue();
    leave();

    assertStopArrives();
    String output = broker.output();
    System.out.println(output);
    assertThat(output).contains("connection not accepted");
    assertThat(output.lines().filter(line -> line.contains("Too many open files")))
        .hasSizeLessThan(20);
  }
}
