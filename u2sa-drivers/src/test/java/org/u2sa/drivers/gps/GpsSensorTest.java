package org.u2sa.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.GpsSensor;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.Recordings;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

class GpsSensorTest {
  private static final double MICRO = 1e-6;

  @TempDir Path folder;
  private final ServiceKit kit = new ServiceKit();
  private final MemoryLink link = new MemoryLink();

  @AfterEach
  void end() {
    kit.close();
  }

  private void startNmea() {
    kit.start(context -> new GpsSensor(context, LinkedGps.listening(link, new NmeaGps())));
  }

  private List<StateInformation> published() {
    return kit.published(Channels.SENSED_STATE);
  }

  private Optional<String> lastError() {
    kit.advance(0.5);
    return kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError);
  }

  private void say(String... bodies) {
    link.fromDevice(Nmea.bytes(bodies));
  }

  private static String rmc(int second) {
    return String.format(
        "GPRMC,1200%02d.00,A,3713.5000,N,08025.2000,W,10.0,90.0,211126,,,A", second);
  }

  private static String gga(int second) {
    return String.format(
        "GPGGA,1200%02d.00,3713.5000,N,08025.2000,W,1,08,1.0,634.2,M,,M,,", second);
  }

  @Test
  void step_fix_isPublishedInGlobal() {
    startNmea();
    say("GPGST,120000.00,1.8,,,,1.0,1.0,2.2", rmc(0), gga(0), rmc(1), gga(1));
    kit.advance(0.1);

    StateInformation state = kit.latest(Channels.SENSED_STATE).orElseThrow();
    assertThat(state.referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertThat(state.sensorName()).isEqualTo("GpsSensor");
    assertThat(state.x().orElseThrow()).isCloseTo(-80.42, within(MICRO));
    assertThat(state.y().orElseThrow()).isCloseTo(37.225, within(MICRO));
    assertThat(state.z()).hasValue(634.2);
    assertThat(state.xDot().orElseThrow()).isCloseTo(5.14444, within(1e-4));
    assertThat(state.yDot().orElseThrow()).isCloseTo(0.0, within(MICRO));
    assertThat(state.zDot()).isEmpty();
    assertThat(state.xSigma().orElseThrow()).isCloseTo(1.0, within(MICRO));
    assertThat(state.ySigma()).isEqualTo(state.xSigma());
    assertThat(state.zSigma()).hasValue(2.2);
    assertThat(state.psi()).as("a course is no heading").isEmpty();
  }

  @Test
  void step_delayIsKnown_fixHasTheTimeThatItIsOf() {
    kit.with("DELAY", 0.15);
    startNmea();
    kit.advance(1.0);
    say(rmc(0), gga(0), rmc(1), gga(1));
    kit.advance(0.02); // one step: it arrives there

    assertThat(kit.latest(Channels.SENSED_STATE).orElseThrow().timestamp())
        .hasValue(1_020_000L - 150_000L);
  }

  @Test
  void step_nothingNew_nothingIsPublished() {
    startNmea();
    say(rmc(0), gga(0), rmc(1), gga(1));
    kit.advance(0.1);
    int before = published().size();
    kit.advance(5.0);

    assertThat(published()).hasSize(before);
    assertThat(lastError()).hasValue("the GPS receiver has sent no valid data for more than 2.5 s");
  }

  @Test
  void step_noFix_isSaidAndNothingPublished() {
    startNmea();
    say("GPRMC,120000.00,V,,,,,,,,,,N", "GPGGA,120000.00,,,,,0,03,,,M,,M,,");
    say("GPRMC,120001.00,V,,,,,,,,,,N");
    kit.advance(0.1);
    assertThat(published()).isEmpty();
    assertThat(lastError()).hasValue("the GPS receiver has no fix (3 satellites)");

    say("GPGGA,120001.00,,,,,0,03,,,M,,M,,", rmc(2), gga(2));
    kit.advance(0.1);
    assertThat(published()).hasSize(1);
    assertThat(kit.log("GpsSensor"))
        .anySatisfy(line -> assertThat(line).contains("the GPS receiver has a fix"));
  }

  @Test
  void step_ublox6_isSetUpAndSetUpAgainAfterItWasLost() {
    SimulatedUblox receiver = new SimulatedUblox(link);
    kit.start(
        context -> new GpsSensor(context, LinkedGps.ublox(link, UbloxModel.UBLOX_6, 9600, 5.0)));
    kit.advance(1.0);
    receiver.solve();
    kit.advance(0.1);
    assertThat(published()).hasSize(1);
    assertThat(published().get(0).y().orElseThrow()).isCloseTo(-37.2295733, within(MICRO));

    receiver.restart();
    kit.advance(2.0);
    receiver.solve();
    kit.advance(0.1);
    assertThat(receiver.heard()).hasSize(10).doesNotContain("?");
  }

  @Test
  void step_receiverRefusesItsSetup_isSaid() {
    SimulatedUblox receiver = new SimulatedUblox(link);
    receiver.refuse("CFG-MSG-0107");
    kit.start(
        context -> new GpsSensor(context, LinkedGps.ublox(link, UbloxModel.UBLOX_8, 9600, 5.0)));

    assertThat(lastError()).hasValue("the receiver rejected CFG-MSG for 01-07");
  }

  @Test
  void replay_ofARecordedRun_publishesTheSame() throws Exception {
    Path file = folder.resolve("gps.rec");
    List<String> first;
    try (ServiceKit recorded = new ServiceKit()) {
      MemoryLink device = new MemoryLink();
      recorded.start(
          context ->
              new GpsSensor(
                  context,
                  LinkedGps.listening(
                      Recordings.record(device, file, recorded.clock()), new NmeaGps())));
      for (int second = 0; second < 30; second++) {
        if (second == 10) {
          device.unplug();
        } else if (second == 15) {
          device.plug();
        }
        device.fromDevice(Nmea.bytes(rmc(second), gga(second)));
        recorded.advance(1.0);
      }
      first = texts(recorded);
    }
    kit.with("CONNECTION", "replay:" + file).start(GpsSensor::new);
    kit.advance(40.0);

    assertThat(first).hasSizeGreaterThan(20);
    assertThat(texts(kit)).isEqualTo(first);
    assertThat(lastError()).hasValue("the GPS receiver is lost: the recording has ended");
  }

  private static List<String> texts(ServiceKit run) {
    return run.published(Channels.SENSED_STATE).stream().map(Object::toString).toList();
  }

  @Test
  void construct_badAddress_isRefused() {
    kit.with("CONNECTION", "usb:1");
    assertThatThrownBy(() -> new GpsSensor(kit.context()))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith("link address \"usb:1\": unknown kind \"usb\"");
  }
}
