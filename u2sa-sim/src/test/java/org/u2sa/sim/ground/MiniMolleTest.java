package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.ioio.PulseTrain;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.UbloxSettings;
import org.u2sa.sim.world.World;

class MiniMolleTest {
  private static final World WORLD = World.at(new Geodetic(-80.42, 37.23, 600.0));
  private static final int GPS = 6;
  private static final int LEFT = 10;
  private static final int RIGHT = 11;
  private static final int RADIO = 35;
  private static final int BATTERY = 40;
  private static final long BEGIN = 1_700_000_000_000_000L; // a run's clock may begin anywhere

  private final byte[] buffer = new byte[64];
  private final StringBuilder heard = new StringBuilder();
  private long nowUs = BEGIN;

  @Test
  void driven_sameWidths_drivesNorth() {
    MiniMolle molle = MiniMolle.in(WORLD).build();
    drive(molle, 1_800, 1_800);
    run(molle, 5.0);
    assertThat(molle.state().northM()).isGreaterThan(4.0);
    assertThat(molle.command().first()).isEqualTo(0.6, within(1e-9));
    assertThat(molle.command().second()).isEqualTo(0.6, within(1e-9));
    assertThat(WORLD.plane().at(molle.state().eastM(), molle.state().northM(), 0.0).latitudeDeg())
        .isGreaterThan(37.23003);
    assertThat(molle.state().timeS()).isEqualTo(5.0);
  }

  @Test
  void driven_pulsesStop_motorsAreOffAfterATenthOfASecond() {
    MiniMolle molle = MiniMolle.in(WORLD).build();
    drive(molle, 1_800, 1_200);
    run(molle, 1.0);
    molle.released(LEFT);
    molle.driven(RIGHT, PulseTrain.NONE);
    run(molle, 0.07);
    assertThat(molle.command().first()).isEqualTo(0.6, within(1e-9));
    run(molle, 0.04);
    assertThat(molle.command()).isEqualTo(DriveCommand.none());
    assertThat(molle.state().leftMotorA()).isZero();
  }

  @Test
  void driven_widthsOutsideAServosRange_areNoPulses() {
    MiniMolle molle = MiniMolle.in(WORLD).build();
    drive(molle, 500, 3_000);
    run(molle, 1.0);
    assertThat(molle.command()).isEqualTo(DriveCommand.none());
  }

  @Test
  void received_gpsAndCompass_speakAtTheirRatesOnly() {
    MiniMolle molle =
        MiniMolle.in(WORLD).gps(GpsParameters.survey(), UbloxSettings.factory()).build();
    run(molle, 3.0);
    assertThat(heard).contains("$GPRMC,120001.00,A,3713.");
    byte[] request = {(byte) 0xA4, 0x09, (byte) 0xA0};
    molle.transmitted(14, 9_600, request, request.length);
    nowUs += 20_000;
    molle.advance(nowUs);
    assertThat(molle.received(13, 115_200, buffer)).isZero();
    molle.transmitted(14, 9_600, request, request.length);
    nowUs += 20_000;
    molle.advance(nowUs);
    assertThat(molle.received(13, 9_600, buffer)).isEqualTo(5);
  }

  @Test
  void received_afterSilenceOfTheListener_beginsWithWhatComesThen() {
    MiniMolle molle =
        MiniMolle.in(WORLD).gps(GpsParameters.survey(), UbloxSettings.factory()).build();
    for (int i = 0; i < 5_500; i++) {
      nowUs += 1_000;
      molle.advance(nowUs);
    }
    run(molle, 1.0);
    assertThat(heard.toString()).doesNotContain("12000" + 4).contains("120006.00");
  }

  @Test
  void volts_fullBattery_areDivided() {
    MiniMolle molle = MiniMolle.in(WORLD).build();
    run(molle, 0.1);
    assertThat(molle.volts(BATTERY)).isCloseTo(0.2 * 12.78, within(0.06));
    assertThat(molle.volts(BATTERY + 1)).isZero();
  }

  @Test
  void hazards_manual_sticksDriveAndTheSwitchSaysSo() {
    DriveCommand sticks = new DriveCommand(0.3, 0.2);
    MiniMolle molle =
        MiniMolle.in(WORLD)
            .hazards(Hazards.none().with(new DrivingHazard.Manual(1, 2, sticks)))
            .build();
    drive(molle, 1_900, 1_900);
    run(molle, 0.9);
    assertThat(molle.pulses(RADIO).widthS()).isGreaterThan(1.7e-3);
    run(molle, 0.2);
    assertThat(molle.command()).isEqualTo(sticks);
    assertThat(molle.pulses(RADIO).widthS()).isLessThan(1.3e-3);
    run(molle, 1.0);
    assertThat(molle.command().first()).isEqualTo(0.8, within(1e-9));
  }

  @Test
  void hazards_radioSilence_nobodyDrives() {
    MiniMolle molle =
        MiniMolle.in(WORLD)
            .hazards(Hazards.none().with(new DrivingHazard.RadioSilence(1, 2)))
            .build();
    drive(molle, 1_900, 1_900);
    run(molle, 1.5);
    assertThat(molle.command()).isEqualTo(DriveCommand.none());
    assertThat(molle.pulses(RADIO).present()).isFalse();
  }

  @Test
  void hazards_gpsOutage_rmcIsInvalidThen() {
    MiniMolle molle =
        MiniMolle.in(WORLD)
            .gps(GpsParameters.survey(), UbloxSettings.factory())
            .hazards(Hazards.none().with(new DrivingHazard.GpsOutage(1.5, 2.5)))
            .build();
    run(molle, 4.0);
    assertThat(heard).contains("$GPRMC,120001.00,A,").contains("$GPRMC,120002.00,V,");
    assertThat(heard).contains("$GPRMC,120003.00,A,");
  }

  @Test
  void hazards_multipath_positionIsOffThenAndTheReceiverDoesNotKnow() {
    MiniMolle molle =
        MiniMolle.in(WORLD)
            .gps(GpsParameters.survey(), UbloxSettings.factory())
            .hazards(Hazards.none().with(new DrivingHazard.Multipath(1.5, 2.5, 100.0, 0.0)))
            .build();
    run(molle, 4.0);
    double minute =
        WORLD.plane().at(100.0, 0.0, 0.0).longitudeDeg()
            - WORLD.plane().at(0.0, 0.0, 0.0).longitudeDeg();
    assertThat(westMinutes("120002.00") - westMinutes("120001.00"))
        .isCloseTo(-60.0 * minute, within(1e-4));
    assertThat(westMinutes("120003.00")).isCloseTo(westMinutes("120001.00"), within(1e-4));
  }

  /** Minutes of longitude of a fix that the receiver calls valid. */
  private double westMinutes(String time) {
    String fix = "$GPRMC," + time + ",A,";
    assertThat(heard).contains(fix);
    String longitude = heard.substring(heard.indexOf(fix)).split(",")[5];
    return Double.parseDouble(longitude.substring(3));
  }

  @Test
  void hazards_batteryAndPush_areFelt() {
    MiniMolle molle =
        MiniMolle.in(WORLD)
            .hazards(
                Hazards.none()
                    .with(new DrivingHazard.BatteryAt(1.0, 0.1))
                    .with(new DrivingHazard.Push(2.0, 3.0, 150.0, 0.0, 0.0)))
            .build();
    run(molle, 1.5);
    assertThat(molle.state().batteryV()).isLessThan(12.0);
    assertThat(molle.state().eastM()).isZero();
    run(molle, 3.0);
    assertThat(molle.state().eastM()).isGreaterThan(0.01);
  }

  @Test
  void hazards_slipperyUnderOneWheel_turnsTheVehicleThatWay() {
    MiniMolle molle =
        MiniMolle.in(WORLD)
            .hazards(Hazards.none().with(new DrivingHazard.Slippery(2.22, 0.0, 2.1, 0.05)))
            .build();
    drive(molle, 2_000, 2_000);
    run(molle, 0.5);
    assertThat(molle.state().headingRad()).isBetween(0.02, Math.PI); // the left wheel pulls on
  }

  @Test
  void hazards_magneticPlace_deflectsTheCompassNearItOnly() {
    assertThat(headingDegAt(new GroundStart(5.0, 5.0, 0.0))).isBetween(10.0, 40.0);
    assertThat(headingDegAt(new GroundStart(40.0, 0.0, 0.0))).isCloseTo(0.0, within(0.1));
  }

  private double headingDegAt(GroundStart start) {
    MiniMolle molle =
        MiniMolle.in(WORLD)
            .vehicle(new DifferentialVehicle(DifferentialParameters.miniMolle(), start))
            .compass(CompassParameters.perfect(0.0), 9_600)
            .hazards(Hazards.none().with(new DrivingHazard.Magnetic(5.0, 5.0, 1.0, -10.0, 0.0)))
            .build();
    run(molle, 0.1);
    byte[] request = {(byte) 0xA4, 0x09, (byte) 0xA0};
    molle.transmitted(14, 9_600, request, request.length);
    nowUs += 10_000;
    molle.advance(nowUs);
    assertThat(molle.received(13, 9_600, buffer)).isEqualTo(5);
    return ((buffer[2] & 0xFF) << 8 | buffer[3] & 0xFF) * 360.0 / 4096.0;
  }

  @Test
  void advance_sameSeed_givesTheSameBytesAndPath() {
    Hazards hazards = Hazards.random(3L, 10.0, 120.0);
    String[] heardOf = new String[3];
    GroundState[] states = new GroundState[3];
    for (int i = 0; i < 3; i++) {
      heard.setLength(0);
      nowUs = BEGIN + i * 1_000_000L;
      MiniMolle molle = MiniMolle.in(WORLD).hazards(hazards).seed(i < 2 ? 5L : 6L).build();
      drive(molle, 1_800, 1_700);
      run(molle, 60.0);
      heardOf[i] = heard.toString();
      states[i] = molle.state();
    }
    assertThat(heardOf[1]).isEqualTo(heardOf[0]);
    assertThat(states[1]).isEqualTo(states[0]);
    assertThat(heardOf[2]).isNotEqualTo(heardOf[0]);
    assertThat(states[2]).isEqualTo(states[0]); // the sensors' seed is none of the vehicle's
  }

  private void drive(MiniMolle molle, int leftUs, int rightUs) {
    molle.advance(nowUs);
    molle.driven(LEFT, new PulseTrain(leftUs * 1e-6, 0.02));
    molle.driven(RIGHT, new PulseTrain(rightUs * 1e-6, 0.02));
  }

  /** As a board does, a millisecond at a time. */
  private void run(MiniMolle molle, double seconds) {
    long end = nowUs + Math.round(seconds * 1e6);
    while (nowUs < end) {
      nowUs += 1_000;
      molle.advance(nowUs);
      for (int count = 1; count > 0; ) {
        count = molle.received(GPS, 9_600, buffer);
        heard.append(new String(buffer, 0, count, StandardCharsets.ISO_8859_1));
      }
    }
  }
}
