package org.u2sa.world.scanmap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.grid.GridModeller;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/** Localisation on a saved map from starts that are known to metres only. */
class SavedMapStartTest {
  private static final Pose2 START = new Pose2(3.5, 1.5, 0.0);

  @TempDir private static Path folder; // a room's map is made once
  private final Random random = new Random(3);
  private long micros = 1_000_000L;

  private ScanMapModeller modeller(Map<String, Object> variables) {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", variables);
    ScanMapModeller modeller =
        new ScanMapModeller(
            configuration, new GridModeller(configuration), folder::resolve, true, true);
    MapFrame frame = MapFrame.of(state(START, 0.01, 0.01));
    modeller.enter(frame, new Sighting(0L, MapFrame.BODY, Optional.empty()));
    return modeller;
  }

  /** A modeller with the map of a room, which starts east and north of START, turned left. */
  private ScanMapModeller started(
      String map, double east, double north, double turnDeg, double sigmaM, double sigmaDeg) {
    String start = (START.y() + north) + " " + (START.x() + east) + " " + (90.0 - turnDeg);
    Map<String, Object> variables = new HashMap<>(Map.of("MAP FILE", map));
    variables.put("MAP START", start);
    variables.put("MAP START SIGMA", sigmaM);
    variables.put("MAP START PSI SIGMA", sigmaDeg);
    return modeller(variables);
  }

  @BeforeAll
  static void saveMaps() {
    SavedMapStartTest test = new SavedMapStartTest();
    List<Pose2> circle =
        IntStream.rangeClosed(0, 60).mapToObj(SavedMapStartTest::onCircle).toList();
    test.save("hall.map", Room.hall(), circle);
    test.save("bare.map", Room.bare(8.0, 6.0), circle);
    test.save(
        "pillars.map",
        Room.pillars(2.0),
        IntStream.rangeClosed(0, 75).mapToObj(i -> new Pose2(0.4 * i, 0.0, 0.0)).toList());
  }

  private void save(String map, Room room, List<Pose2> way) {
    ScanMapModeller first = modeller(Map.of("SAVE MAP", map));
    way.forEach(pose -> scan(first, room, pose, pose, 0.01));
    first.end();
  }

  private static Pose2 onCircle(int i) {
    double angle = 2.0 * Math.PI * i / 60.0;
    return new Pose2(
        START.x() + 1.5 * Math.sin(angle),
        START.y() + 1.5 - 1.5 * Math.cos(angle),
        Pose2.wrapped(angle));
  }

  private StateInformation state(Pose2 pose, double sigmaM, double sigmaRad) {
    StateInformation state =
        new StateInformation()
            .sensorName("StateEstimator")
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(pose.x())
            .y(pose.y())
            .psi(pose.theta())
            .xSigma(sigmaM)
            .ySigma(sigmaM)
            .psiSigma(sigmaRad);
    state.timestamp(micros);
    return state;
  }

  /** Scans once; returns the errors of the corrections, in their standard deviations. */
  private List<Double> scan(
      ScanMapModeller modeller, Room room, Pose2 truth, Pose2 told, double sigmaM) {
    micros += 100_000L;
    RangeScan scan = room.scan(truth, 20.0, 0.01, random);
    scan.timestamp(micros);
    StateInformation state = state(told, sigmaM, sigmaM / 6.0);
    modeller.scan(
        scan, ScanPoses.still(new Sighting(micros, MapFrame.of(state), Optional.of(state))));
    List<Double> errors = new ArrayList<>();
    for (StateInformation each : modeller.corrections()) {
      double x = (each.x().orElseThrow() - truth.x()) / each.xSigma().orElseThrow();
      double y = (each.y().orElseThrow() - truth.y()) / each.ySigma().orElseThrow();
      errors.add(Math.hypot(x, y));
    }
    return errors;
  }

  private List<Double> drive(ScanMapModeller modeller, Room room) {
    List<Double> errors = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      errors.addAll(scan(modeller, room, onCircle(i), onCircle(i), 0.01));
    }
    return errors;
  }

  @ParameterizedTest
  @CsvSource({
    "1, 3, 30, 3, 30",
    "1, 3, 30, 2, 20",
    "3, 0, 0, 3, 10",
    "-1, -3, -30, 3, 30",
    "-2.5, 3, 60, 3, 30",
    "1, -1, -15, 1, 15",
    "3, -2.5, 45, 2, 20",
    "-3, -2.5, -60, 4, 25",
    "0.5, 0.5, -50, 0.3, 30"
  })
  void scan_startFarOffInAHall_poseIsTheTrueOne(
      double east, double north, double turnDeg, double sigmaM, double sigmaDeg) {
    List<Double> errors =
        drive(started("hall.map", east, north, turnDeg, sigmaM, sigmaDeg), Room.hall());

    assertThat(errors).hasSizeGreaterThan(25).allMatch(sigmas -> sigmas < 3.0);
  }

  @Test
  void scan_roomLooksTheSameHalfATurnFarther_noneOfTheTwoIsTaken() {
    Room room = Room.bare(8.0, 6.0);
    ScanMapModeller modeller = started("bare.map", 0.5, 2.5, 100.0, 2.0, 60.0);

    assertThat(drive(modeller, room)).isEmpty();
    assertThat(modeller.remark()).contains("several places look alike");
  }

  @Test
  void scan_roomLooksTheSameButHeadingIsKnown_poseIsTheTrueOne() {
    Room room = Room.bare(8.0, 6.0);
    List<Double> errors = drive(started("bare.map", 1.5, 2.5, 40.0, 2.0, 20.0), room);

    assertThat(errors).hasSizeGreaterThan(25).allMatch(sigmas -> sigmas < 3.0);
  }

  @Test
  void scan_pillarsOfACorridorLookAlike_noneIsTaken() {
    Room room = Room.pillars(2.0);
    Map<String, Object> variables = new HashMap<>(Map.of("MAP FILE", "pillars.map"));
    variables.put("MAP START", "0 12.2 90");
    variables.put("MAP START SIGMA", 1.5);
    ScanMapModeller modeller = modeller(variables);
    List<Double> errors = new ArrayList<>();
    for (int i = 0; i <= 40; i++) {
      Pose2 pose = new Pose2(15.0 + 0.4 * i, 0.0, 0.0);
      errors.addAll(scan(modeller, room, pose, pose, 0.01));
    }

    assertThat(errors).isEmpty();
    assertThat(modeller.remark()).contains("lost on the saved map: several places look alike");
  }

  @Test
  void scan_lostWhileThePositionIsTooUncertain_isFoundOnceItIsNot() {
    ScanMapModeller modeller = modeller(Map.of("MAP FILE", "hall.map"));
    Pose2 told = new Pose2(START.x() + 2.0, START.y() + 2.0, 0.2);

    assertThat(scan(modeller, Room.hall(), START, told, 8.0)).isEmpty();
    assertThat(modeller.remark()).contains("known to 8 m (1 sigma), at most 5 m are searched");
    assertThat(scan(modeller, Room.hall(), START, told, 2.0))
        .hasSize(1)
        .allMatch(sigmas -> sigmas < 3.0);
  }

  @Test
  void enter_startTooUncertainForASavedMap_isRefused() {
    assertThatThrownBy(
            () ->
                modeller(Map.of("MAP FILE", "a.map", "MAP START", "0 0 0", "MAP START SIGMA", 6.0)))
        .hasMessageContaining("MAP START SIGMA: 6.0 m")
        .hasMessageContaining("at most 5.0 m");
  }

  /** A restarted modeller hears scans before the first state: the vehicle is elsewhere by then. */
  @Test
  void scan_beforeTheFirstState_tellsMapStartAtTheStartOfTheRunOnly() {
    XmlConfiguration configuration =
        XmlConfiguration.inMemory("test", Map.of("MAP START", "3 1 30"));
    for (boolean isFirst : new boolean[] {true, false}) {
      ScanMapModeller modeller =
          new ScanMapModeller(
              configuration, new GridModeller(configuration), folder::resolve, true, isFirst);
      Sighting blind = new Sighting(micros, MapFrame.BODY, Optional.empty());
      modeller.enter(MapFrame.BODY, blind);
      RangeScan scan = Room.hall().scan(START, 20.0, 0.01, random);
      scan.timestamp(micros);
      modeller.scan(scan, ScanPoses.still(blind));

      assertThat(modeller.corrections()).hasSize(isFirst ? 1 : 0);
    }
  }
}
