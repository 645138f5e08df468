package org.u2sa.drivers.compass;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.CompassSensor;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.MagneticModel;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

class CompassSensorTest {
  private static final double TINY = 1e-9;
  private static final double LATITUDE_DEG = 37.22957;
  private static final double LONGITUDE_DEG = -80.42336;

  private final ServiceKit kit = new ServiceKit();
  private final MemoryLink link = new MemoryLink();

  @AfterEach
  void end() {
    kit.close();
  }

  private void start() {
    kit.start(context -> new CompassSensor(context, LinkedCompass.nmea(link)));
  }

  private void say(String body) {
    link.fromDevice(Nmea.bytes(body));
    kit.advance(0.1);
  }

  private void tellPosition() {
    kit.publish(
        Channels.STATE,
        new StateInformation()
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(LONGITUDE_DEG)
            .y(LATITUDE_DEG));
  }

  private List<StateInformation> published() {
    return kit.published(Channels.SENSED_STATE);
  }

  private double psiDeg() {
    return Math.toDegrees(kit.latest(Channels.SENSED_STATE).orElseThrow().psi().orElseThrow());
  }

  private Optional<String> lastError() {
    kit.advance(0.5);
    return kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError);
  }

  @Test
  void step_magneticHeading_isPublishedAsTrueOne() {
    start();
    tellPosition();
    say("HCHDM,101.5,M");

    double declinationDeg =
        Math.toDegrees(MagneticModel.declinationRad(LATITUDE_DEG, LONGITUDE_DEG, 0.0, 2025.0));
    assertThat(declinationDeg).as("Blacksburg, Virginia, lies west").isBetween(-10.0, -7.0);
    assertThat(psiDeg()).isCloseTo(101.5 + declinationDeg, within(TINY));
    StateInformation state = published().get(0);
    assertThat(state.referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertThat(state.psiSigma().orElseThrow()).isCloseTo(Math.toRadians(1.0), within(TINY));
    assertThat(state.x()).isEmpty();
  }

  @Test
  void step_acrossNorth_staysInATurn() {
    start();
    tellPosition();
    say("HCHDM,1.0,M");

    assertThat(psiDeg()).isBetween(350.0, 360.0);
  }

  @Test
  void step_positionNotKnown_magneticHeadingWaitsAndIsSaid() {
    start();
    say("HCHDM,101.5,M");
    assertThat(published()).isEmpty();
    assertThat(lastError())
        .hasValue(
            "no heading is published: true north is unknown until the vehicle's position is known");

    tellPosition();
    say("HCHDM,101.5,M");
    assertThat(published()).hasSize(1);
  }

  @Test
  void step_trueHeading_needsNoPosition() {
    start();
    say("HCHDT,101.5,T");

    assertThat(psiDeg()).isCloseTo(101.5, within(TINY));
  }

  @Test
  void step_fixedDeclinationAndMountingAngle_areTakenIntoAccount() {
    kit.with("NORTH", "FIXED")
        .with("DECLINATION", Math.toRadians(-8.0))
        .with("MOUNTING ANGLE", Math.toRadians(90.0));
    start();
    say("HCHDM,100.0,M");

    assertThat(psiDeg()).as("its front points to the vehicle's right").isCloseTo(2.0, within(TINY));
  }

  @Test
  void step_sparton_isAskedForEachHeading() {
    int[] asked = {0};
    link.with(
        bytes -> {
          asked[0]++;
          assertThat(bytes).isEqualTo(SpartonCompass.request());
          if (asked[0] != 3) { // one answer is lost
            link.fromDevice(
                (byte) 0xA4, (byte) 0x09, (byte) (asked[0] >> 8), (byte) asked[0], (byte) 0xA0);
          }
        });
    kit.with("NORTH", "FIXED");
    kit.start(context -> new CompassSensor(context, LinkedCompass.sparton(link)));
    kit.advance(2.0);

    assertThat(published()).hasSizeGreaterThan(50);
    assertThat(psiDeg()).isCloseTo((asked[0] - 1) * 360.0 / 4096, within(0.1));
    assertThat(asked[0]).isEqualTo(published().size() + 2);
  }
}
