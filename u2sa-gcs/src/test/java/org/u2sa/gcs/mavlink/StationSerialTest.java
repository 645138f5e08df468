package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.ParamRequestList;
import io.dronefleet.mavlink.common.ParamValue;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.util.EnumValue;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.SerialLine;
import org.u2sa.mavlink.MavlinkStream;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.safety.EmergencyStop;

/** A slow serial line, whose other end the test holds. */
class StationSerialTest {
  private static final int BAUD = 9_600;
  private static final int TURN_MICROS = 10_000;

  private final BridgeKit kit = BridgeKit.rover().ready();
  private final Cable cable = new Cable();
  private final SerialLink link = new SerialLink(cable, BAUD, kit.session);
  private final MavlinkStream station = new MavlinkStream(BridgeKit.STATION, 190);
  private final List<Object> received = new ArrayList<>();
  private int bytes;

  private static final class Cable implements SerialLine {
    private final ByteArrayOutputStream toStation = new ByteArrayOutputStream();
    private byte[] toBridge = new byte[0];
    private boolean isPlugged = true;

    @Override
    public int read(byte[] buffer) {
      int length = Math.min(buffer.length, toBridge.length);
      System.arraycopy(toBridge, 0, buffer, 0, length);
      toBridge = Arrays.copyOfRange(toBridge, length, toBridge.length);
      return length;
    }

    @Override
    public boolean write(byte[] bytes) {
      if (isPlugged) {
        toStation.writeBytes(bytes);
      }
      return isPlugged;
    }

    @Override
    public void close() {
      isPlugged = false;
    }
  }

  private void pass(double seconds) throws IOException {
    for (int turn = 0; turn < seconds * 1.0e6 / TURN_MICROS; turn++) {
      long now = kit.clock.addAndGet(TURN_MICROS);
      kit.says(
          new StateInformation()
              .x(BridgeKit.LONGITUDE)
              .y(BridgeKit.LATITUDE)
              .z(3.0)
              .xDot(1.0)
              .yDot(0.0)
              .psi(1.0));
      kit.vehicle.model.refresh();
      kit.vehicle.orders.step(now);
      kit.session.step(now);
      link.exchange(now);
      byte[] sent = cable.toStation.toByteArray();
      cable.toStation.reset();
      bytes += sent.length;
      station.accept(sent, sent.length, message -> received.add(message.payload()));
    }
  }

  private long count(Class<?> type) {
    return received.stream().filter(type::isInstance).count();
  }

  @Test
  void exchange_moreTelemetryThanTheLineCarries_keepsToItsRateAndStarvesNoMessage()
      throws IOException {
    pass(10.0);
    received.clear();
    bytes = 0;
    pass(10.0);

    assertThat(bytes).isBetween(8_500, 9_900); // 960 bytes/s
    assertThat(count(Heartbeat.class)).isBetween(9L, 11L);
    assertThat(count(Attitude.class)).isGreaterThan(30);
    assertThat(received.stream().map(Object::getClass).distinct().count()).isGreaterThan(8);
  }

  @Test
  void exchange_parametersBesideTelemetry_bothGoOn() throws IOException {
    kit.says(
        new ConfigurationResponse()
            .serviceName("Control")
            .variables(
                IntStream.range(0, 200)
                    .mapToObj(
                        i ->
                            new ConfigurationVariable()
                                .name("GAIN " + i)
                                .variableType("double")
                                .value("1.0"))
                    .collect(Collectors.toList())));
    pass(5.0);
    received.clear();
    cable.toBridge = station.encode(ParamRequestList.builder().targetSystem(1).build());
    pass(5.0);

    assertThat(count(ParamValue.class)).isGreaterThan(30);
    assertThat(count(Attitude.class)).isGreaterThan(8);
    assertThat(count(Heartbeat.class)).isGreaterThanOrEqualTo(4);
  }

  @Test
  void exchange_command_isAnsweredWithinHalfASecondOnAFullLine() throws IOException {
    pass(10.0);
    received.clear();
    cable.toBridge =
        station.encode(
            CommandLong.builder()
                .targetSystem(1)
                .targetComponent(1)
                .command(EnumValue.create(MavCmd.class, 42_424))
                .build());
    pass(0.5);
    assertThat(count(CommandAck.class)).isEqualTo(1);
  }

  private static final CommandLong STOP =
      CommandLong.builder()
          .targetSystem(1)
          .targetComponent(1)
          .command(MavCmd.MAV_CMD_DO_FLIGHTTERMINATION)
          .param1(1.0f)
          .build();

  private void send(byte[]... parts) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] part : parts) {
      all.writeBytes(part);
    }
    cable.toBridge = all.toByteArray();
  }

  private static byte[] repeated(byte[] part, int times) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (int i = 0; i < times; i++) {
      all.writeBytes(part);
    }
    return all.toByteArray();
  }

  /** As a line's buffer holds them after seconds of sticks faster than the allowance. */
  @Test
  void exchange_stopBehindMoreSticksThanAllowed_isObeyedAtOnceAndNoStickWaits() throws IOException {
    byte[] stick =
        station.encode(
            ManualControl.builder()
                .target(1)
                .x(600)
                .buttons(0xFFFF)
                .enabledExtensions(255)
                .build());
    send(repeated(stick, 3_000), station.encode(STOP), repeated(stick, 100));
    pass(0.03);

    assertThat(cable.toBridge).isEmpty();
    assertThat(kit.orders(EmergencyStop.class)).hasSize(1);
  }

  @Test
  void exchange_stopAfterTheAllowanceInPieces_isObeyed() throws IOException {
    byte[] ask = station.encode(StationPackets.requestVersion());
    byte[] stop = station.encode(STOP);
    send(repeated(ask, 2_000));
    pass(0.05);
    send(Arrays.copyOf(stop, 20));
    pass(0.01);
    send(Arrays.copyOfRange(stop, 20, stop.length));
    pass(0.01);
    assertThat(kit.orders(EmergencyStop.class)).hasSize(1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"FDFF", "FE", "FD2101000000004C0000"})
  void exchange_noiseThatLooksLikePackets_holdsUpNeitherAStopNorLongACommand(String noise)
      throws IOException {
    byte[] pattern = HexFormat.of().parseHex(noise);
    send(repeated(pattern, 64 * 1024 / pattern.length), station.encode(STOP));
    pass(1.0);
    List<EmergencyStop> stops = kit.orders(EmergencyStop.class);
    assertThat(stops).isNotEmpty().containsOnly(stops.get(0)); // repeated until it is forwarded

    received.clear();
    send(station.encode(StationPackets.requestVersion()));
    pass(0.7);
    assertThat(count(CommandAck.class)).isGreaterThanOrEqualTo(1);
  }

  /** The start of a packet of 280 bytes that nobody sends. */
  @Test
  void exchange_stopBehindAFalseStart_isObeyedThoughNothingFollows() throws IOException {
    send(new byte[] {(byte) 0xFD, (byte) 0xFF, 0}, station.encode(STOP));
    pass(0.7);
    assertThat(kit.orders(EmergencyStop.class)).hasSize(1);
  }

  /** Faster than the usual half second, because a sender's bytes follow each other on a line. */
  @ParameterizedTest
  @CsvSource({"9600, 0.42", "57600, 0.17", "921600, 0.12"})
  void exchange_stopBehindAFalseStart_waitsForTheTimeOfAPacket(int baud, double seconds)
      throws IOException {
    SerialLink fast = new SerialLink(cable, baud, kit.session);
    pass(2.0);
    send(new byte[] {(byte) 0xFD, (byte) 0xFF, 0}, station.encode(STOP));
    for (int turn = 0; turn < seconds * 1.0e6 / TURN_MICROS; turn++) {
      long now = kit.clock.addAndGet(TURN_MICROS);
      fast.exchange(now);
      kit.session.step(now);
    }
    assertThat(kit.orders(EmergencyStop.class)).hasSize(1);
  }

  @Test
  void exchange_unpluggedForAMinute_sendsNothingOldWhenItIsBack() throws IOException {
    cable.isPlugged = false;
    pass(60.0);
    cable.isPlugged = true;
    received.clear();
    pass(2.0);

    long newest = kit.vehicle.uptime.micros() / 1000;
    assertThat(received.stream().filter(Attitude.class::isInstance))
        .isNotEmpty()
        .allSatisfy(
            each -> assertThat(((Attitude) each).timeBootMs()).isGreaterThan(newest - 3_500));
  }

  @ParameterizedTest
  @CsvSource({
    "'serial:/dev/ttyUSB0,baud=115200', serial:/dev/ttyUSB0 at 115200 baud",
    "serial:/dev/ttyS1, serial:/dev/ttyS1 at 57600 baud",
    "'tcp:5760,id=7', tcp:127.0.0.1:5760",
  })
  void options_ofALink_nameItsPlace(String text, String place) {
    assertThat(BridgeOptions.parse(text)).hasToString(place);
  }

  @ParameterizedTest
  @CsvSource({
    "serial:, expected tcp:PORT",
    "'tcp:5760,baud=9600', expected tcp:PORT",
    "'serial:/dev/ttyS1,baud=0', '\"0\": expected 1…4000000'",
    "'serial:/dev/ttyS1,baud=9000000', '\"9000000\": expected 1…4000000'",
  })
  void options_wrong_areRefused(String text, String why) {
    assertThatThrownBy(() -> BridgeOptions.parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(text)
        .hasMessageContaining(why);
  }
}
