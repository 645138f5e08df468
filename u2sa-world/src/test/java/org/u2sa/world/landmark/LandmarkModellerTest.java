package org.u2sa.world.landmark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Sighting;

class LandmarkModellerTest {
  private static final StateInformation VEHICLE = vehicle(0.0, 0.0, Math.PI / 2.0);

  private LandmarkModeller modeller(boolean learns) {
    LandmarkModeller modeller =
        new LandmarkModeller(
            XmlConfiguration.inMemory(
                "test", Map.of("LANDMARK TYPES", "buoy", "LEARN LANDMARKS", learns)));
    modeller.enter(MapFrame.of(VEHICLE), at(0L));
    return modeller;
  }

  private static StateInformation vehicle(double north, double east, double psi) {
    return new StateInformation()
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(north)
        .y(east)
        .psi(psi)
        .xSigma(0.2)
        .ySigma(0.2)
        .psiSigma(0.02);
  }

  private static Sighting at(long micros) {
    return new Sighting(micros, MapFrame.of(VEHICLE), Optional.of(VEHICLE));
  }

  private static ObjectDescription buoy(String uid, double north, double east) {
    return new ObjectDescription()
        .uid(uid)
        .objectType("buoy")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(north)
        .y(east);
  }

  private static ObjectDescription seen(String uid, double ahead, double left) {
    return new ObjectDescription()
        .uid(uid)
        .objectType("buoy")
        .sensorName("Camera")
        .referenceFrame(ReferenceFrame.BODY)
        .x(ahead)
        .y(left);
  }

  @Test
  void objects_knownBuoy_publishesItsPlaceRangeAndBearing() {
    LandmarkModeller modeller = modeller(false);
    modeller.known(List.of(buoy("red", 3.0, 4.0)), at(0L));

    modeller.objects(List.of(seen("red", 4.1, 3.0)), at(5L));

    LandmarkSighting sighting = (LandmarkSighting) modeller.corrections().get(0);
    assertThat(sighting.landmarkX()).hasValue(3.0);
    assertThat(sighting.landmarkY()).hasValue(4.0);
    assertThat(sighting.range().getAsDouble()).isCloseTo(Math.hypot(4.1, 3.0), within(1e-9));
    assertThat(sighting.bearing().getAsDouble())
        .as("to the left, clockwise positive")
        .isCloseTo(-Math.atan2(3.0, 4.1), within(1e-9));
    assertThat(sighting.timestamp()).hasValue(5L);
    assertThat(sighting.x()).as("no position of the vehicle").isEmpty();
    assertThat(modeller.corrections()).as("once only").isEmpty();
  }

  @Test
  void objects_withoutUidBetweenTwoBuoys_isAmbiguous() {
    LandmarkModeller modeller = modeller(false);
    modeller.known(List.of(buoy("red", 0.3, 4.0), buoy("green", -0.3, 4.0)), at(0L));

    modeller.objects(List.of(seen("", 4.0, 0.0)), at(5L));

    assertThat(modeller.corrections()).isEmpty();
  }

  @Test
  void objects_withoutUidNearOneBuoy_isThat() {
    LandmarkModeller modeller = modeller(false);
    modeller.known(List.of(buoy("red", 0.3, 4.0), buoy("green", -9.0, 4.0)), at(0L));

    modeller.objects(List.of(seen("", 4.0, 0.0)), at(5L));

    assertThat(modeller.corrections()).hasSize(1);
  }

  @Test
  void objects_learntBuoySeenOften_tellsNoMoreThanItsPlaceIsKnown() {
    LandmarkModeller modeller = modeller(true);
    for (int i = 0; i < 10; i++) {
      modeller.objects(List.of(seen("new", 4.0, 3.0)), at(i * 100_000L));
    }
    assertThat(modeller.corrections()).as("learnt, not used at once").isEmpty();

    double information = 0.0;
    for (int i = 0; i < 300; i++) {
      modeller.objects(List.of(seen("new", 4.0, 3.0)), at(30_000_000L + i * 100_000L));
      LandmarkSighting sighting = (LandmarkSighting) modeller.corrections().get(0);
      information += 1.0 / Math.pow(sighting.rangeSigma().orElseThrow(), 2.0);
    }
    assertThat(Math.sqrt(1.0 / information)).isGreaterThan(0.12);
  }

  @Test
  void objects_vehicleWithoutState_publishesWhatHasAKnownUid() {
    LandmarkModeller modeller = modeller(false);
    modeller.known(List.of(buoy("red", 3.0, 4.0)), at(0L));
    modeller.enter(MapFrame.BODY, new Sighting(5L, MapFrame.BODY, Optional.empty()));

    modeller.objects(
        List.of(seen("red", 4.0, 3.0), seen("", 4.0, 3.0)),
        new Sighting(5L, MapFrame.BODY, Optional.empty()));

    List<StateInformation> corrections = modeller.corrections();
    assertThat(corrections).hasSize(1);
    LandmarkSighting sighting = (LandmarkSighting) corrections.get(0);
    assertThat(sighting.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_NED);
    assertThat(sighting.landmarkX()).hasValue(3.0);
    assertThat(sighting.bearing().getAsDouble()).isCloseTo(-Math.atan2(3.0, 4.0), within(1e-9));
  }
}
