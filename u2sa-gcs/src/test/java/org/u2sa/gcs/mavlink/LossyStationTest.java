package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.FileTransferProtocol;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.ParamRequestList;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamValue;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.mission.MissionOrder;

/** 1,000 parameters and their metadata over a round trip of 200 ± 40 ms with 5 % loss each way. */
class LossyStationTest {
  private static final int SERVICES = 20;
  private static final int OF_EACH = 50;
  private static final long TURN_MICROS = 10_000;
  private static final long PATIENCE_MICROS = 60_000_000;

  private record Datagram(long dueMicros, boolean toStation, byte[] bytes) {}

  private final BridgeKit kit = BridgeKit.rover();
  private final PriorityQueue<Datagram> air =
      new PriorityQueue<>((a, b) -> Long.compare(a.dueMicros(), b.dueMicros()));
  private Random dice;
  private double stalls; // share of datagrams that take half a second more

  private void send(boolean toStation, byte[] bytes) {
    if (dice.nextDouble() >= 0.05) {
      long delay = 80_000 + dice.nextInt(40_001); // half of 200 ± 40 ms
      delay += stalls > 0.0 && dice.nextDouble() < stalls ? 500_000 : 0;
      air.add(new Datagram(kit.clock.get() + delay, toStation, bytes));
    }
  }

  private void send(Object message) {
    send(false, kit.station.encode(message));
  }

  /** Lets 10 ms pass; hands what reaches the station to it. */
  private void turn(Consumer<Object> heard) {
    long now = kit.clock.addAndGet(TURN_MICROS);
    while (!air.isEmpty() && air.peek().dueMicros() <= now) {
      Datagram each = air.poll();
      if (each.toStation()) {
        kit.station.accept(
            each.bytes(), each.bytes().length, message -> heard.accept(message.payload()));
      } else {
        kit.session.receive(each.bytes(), each.bytes().length, now);
      }
    }
    kit.session.step(now);
    for (byte[] packet = kit.session.poll(); packet != null; packet = kit.session.poll()) {
      send(true, packet);
    }
  }

  private void configure() {
    for (int service = 0; service < SERVICES; service++) {
      List<ConfigurationVariable> variables = new ArrayList<>();
      for (int i = 0; i < OF_EACH; i++) {
        variables.add(
            new ConfigurationVariable()
                .name("VARIABLE " + i)
                .variableType("double")
                .value("" + i)
                .unit("m")
                .description("What the variable of that name is good for, in a sentence."));
      }
      kit.says(
          new ConfigurationResponse()
              .serviceName("S" + (char) ('A' + service) + "ervice")
              .variables(variables));
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void parameters_thousand_areCompleteWithinAMinute(long seed) {
    dice = new Random(seed);
    configure();
    long began = kit.clock.get();
    BitSet heard = new BitSet();
    long lastMicros = began;
    send(ParamRequestList.builder().targetSystem(1).targetComponent(1).build());
    while (heard.cardinality() < SERVICES * OF_EACH) {
      int before = heard.cardinality();
      turn(
          message -> {
            if (message instanceof ParamValue value) {
              assertThat(value.paramCount()).isEqualTo(SERVICES * OF_EACH);
              heard.set(value.paramIndex());
            }
          });
      if (heard.cardinality() > before) {
        lastMicros = kit.clock.get();
      } else if (kit.clock.get() - lastMicros > 1_000_000) { // as QGroundControl: ten at a time
        lastMicros = kit.clock.get();
        for (int asked = 0, at = heard.nextClearBit(0);
            asked < 10 && at < SERVICES * OF_EACH;
            asked++) {
          send(
              ParamRequestRead.builder()
                  .targetSystem(1)
                  .targetComponent(1)
                  .paramIndex(at)
                  .paramId("")
                  .build());
          at = heard.nextClearBit(at + 1);
        }
      }
      assertThat(kit.clock.get() - began)
          .as("of 1000: %s", heard.cardinality())
          .isLessThan(PATIENCE_MICROS);
    }
  }

  /** A station that answers requests as MAVSDK 4.1.0 does: one beyond its next item is ignored. */
  private final class Uploader {
    private static final int COUNT = 200;
    private int next;
    private int retries;
    private boolean isAsked;
    private long sinceMicros;

    void begin() {
      sinceMicros = kit.clock.get();
      send(MissionCount.builder().targetSystem(1).targetComponent(1).count(COUNT).build());
    }

    void hear(Object message) {
      if (!(message instanceof MissionRequestInt request) || request.seq() > next) {
        return;
      }
      isAsked = true;
      retries = request.seq() == next ? 0 : retries;
      requirePatience();
      sinceMicros = kit.clock.get();
      next = request.seq() + 1;
      retries++;
      send(
          MissionItemInt.builder()
              .targetSystem(1)
              .targetComponent(1)
              .seq(request.seq())
              .command(MavCmd.MAV_CMD_NAV_WAYPOINT)
              .x(540_000_000 + request.seq())
              .y(100_000_000)
              .build());
    }

    void pass() {
      if (kit.clock.get() - sinceMicros > 500_000) {
        requirePatience();
        sinceMicros = kit.clock.get();
        retries++;
        if (!isAsked) {
          begin();
        }
      }
    }

    private void requirePatience() {
      assertThat(retries).as("retries at item %s", next).isLessThan(5);
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {3, 4, 11, 25})
  void mission_twoHundredItemsOverALinkThatAlsoStalls_areUploaded(long seed) {
    dice = new Random(seed);
    stalls = 0.02;
    kit.ready();
    Uploader uploader = new Uploader();
    uploader.begin();
    long began = kit.clock.get();
    while (kit.orders(MissionOrder.class).isEmpty()) {
      turn(uploader::hear);
      uploader.pass();
      assertThat(kit.clock.get() - began).isLessThan(2 * PATIENCE_MICROS);
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void metadata_bursts_areCompleteWithinAMinute(long seed) {
    dice = new Random(seed);
    configure();
    byte[] path = "/parameter.json".getBytes(StandardCharsets.US_ASCII);
    byte[] expected = new FileStation(kit).download("/parameter.json");
    assertThat(expected.length).isGreaterThan(100_000);
    long began = kit.clock.get();
    BitSet heard = new BitSet();
    byte[] content = new byte[expected.length];
    int[] session = {-1};
    boolean[] isOver = {true};
    int sequence = 100;
    long asked = 0;
    while (heard.cardinality() < content.length) {
      long idle = kit.clock.get() - asked;
      if (session[0] < 0 ? idle > 1_000_000 : isOver[0] || idle > 1_000_000) {
        sequence += session[0] < 0 ? 0 : 1000;
        boolean opens = session[0] < 0;
        send(request(sequence, opens, session[0], heard.nextClearBit(0), path));
        asked = kit.clock.get();
        isOver[0] = false;
      }
      long[] latest = {asked};
      turn(
          message -> {
            if (message instanceof FileTransferProtocol answer) {
              byte[] payload = Arrays.copyOf(answer.payload(), 251);
              latest[0] = kit.clock.get();
              if (payload[5] == FileStation.OPEN) {
                session[0] = payload[2];
              } else {
                int offset = ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN).getInt(8);
                int size = payload[4] & 0xFF;
                System.arraycopy(payload, 12, content, offset, size);
                heard.set(offset, offset + size);
                isOver[0] |= payload[6] == 1;
              }
            }
          });
      asked = latest[0];
      assertThat(kit.clock.get() - began)
          .as("of %s: %s", content.length, heard.cardinality())
          .isLessThan(PATIENCE_MICROS);
    }
    assertThat(content).isEqualTo(expected);
  }

  private static FileTransferProtocol request(
      int sequence, boolean opens, int session, int offset, byte[] path) {
    ByteBuffer payload = ByteBuffer.allocate(251).order(ByteOrder.LITTLE_ENDIAN);
    payload.putShort((short) sequence).put((byte) Math.max(0, session));
    payload.put((byte) (opens ? FileStation.OPEN : FileStation.BURST));
    payload.put((byte) (opens ? path.length : 239)).put(new byte[3]).putInt(opens ? 0 : offset);
    payload.put(opens ? path : new byte[0]);
    return FileTransferProtocol.builder()
        .targetSystem(1)
        .targetComponent(1)
        .payload(payload.array())
        .build();
  }
}
