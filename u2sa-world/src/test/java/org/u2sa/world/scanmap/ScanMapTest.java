package org.u2sa.world.scanmap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.grid.GridModeller;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

class ScanMapTest {
  private static final double REACH = 20.0;

  @TempDir private Path folder;
  private final Random random = new Random(3);

  private ScanMapModeller modeller(Map<String, Object> variables) {
    return modeller(variables, true);
  }

  private ScanMapModeller modeller(Map<String, Object> variables, boolean saves) {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", variables);
    ScanMapModeller modeller =
        new ScanMapModeller(
            configuration, new GridModeller(configuration), folder::resolve, saves, true);
    modeller.enter(
        MapFrame.of(state(Pose2.ORIGIN, 0L)), new Sighting(0L, MapFrame.BODY, Optional.empty()));
    return modeller;
  }

  private static StateInformation state(Pose2 pose, long micros) {
    StateInformation state =
        new StateInformation()
            .sensorName("StateEstimator")
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(pose.x())
            .y(pose.y())
            .psi(pose.theta());
    state.timestamp(micros);
    return state;
  }

  /** Drives a circle in the room; the states drift. Returns the errors of the corrections [m]. */
  private List<Double> drive(ScanMapModeller modeller, double drift) {
    List<Double> errors = new ArrayList<>();
    Pose2 told = null;
    Pose2 before = null;
    for (int i = 0; i < 120; i++) {
      double angle = 2.0 * Math.PI * i / 60.0;
      Pose2 truth =
          new Pose2(4.0 + 1.5 * Math.sin(angle), 3.0 - 1.5 * Math.cos(angle), Pose2.wrapped(angle));
      Pose2 step = before == null ? Pose2.ORIGIN : truth.from(before);
      told =
          told == null
              ? truth
              : told.times(
                  new Pose2(step.x() * (1.0 + drift), step.y(), step.theta() * (1.0 + drift)));
      before = truth;
      long micros = 1_000_000L + i * 100_000L;
      RangeScan scan = Room.furnished().scan(truth, REACH, 0.01, random);
      scan.timestamp(micros);
      Sighting sighting =
          new Sighting(micros, MapFrame.of(state(told, micros)), Optional.of(state(told, micros)));
      modeller.scan(scan, ScanPoses.still(sighting));
      for (StateInformation each : modeller.corrections()) {
        errors.add(
            Math.hypot(each.x().orElseThrow() - truth.x(), each.y().orElseThrow() - truth.y()));
      }
    }
    return errors;
  }

  @Test
  void scan_statesDrift_posesOfTheMapDoNot() {
    List<Double> errors = drive(modeller(Map.of()), 0.1);

    assertThat(errors).hasSizeGreaterThan(110).allMatch(error -> error < 0.08);
  }

  /** Each pillar looks like the next: no loop may be closed by a wrong one. */
  @ParameterizedTest
  @ValueSource(doubles = {1.0, 2.0, 3.0})
  void scan_wayBackAlongEqualPillars_staysWhereTheVehicleIs(double everyM) {
    ScanMapModeller modeller = modeller(Map.of());
    Room room = Room.pillars(everyM);
    Pose2 told = Pose2.ORIGIN;
    Pose2 before = Pose2.ORIGIN;
    double worstM = 0.0;
    for (int i = 0; i <= 380; i++) {
      boolean isBack = i > 190;
      int turned = Math.max(0, Math.min(20, i - 180)); // at the end, on the spot
      double x = isBack ? 0.2 * (380 - i) - 2.0 : 0.2 * Math.min(i, 180);
      Pose2 truth = new Pose2(x, 0.0, Pose2.wrapped(Math.PI * turned / 20.0));
      Pose2 step = truth.from(before);
      told = told.times(new Pose2(1.01 * step.x(), step.y(), 1.01 * step.theta()));
      before = truth;
      long micros = 1_000_000L + i * 100_000L;
      RangeScan scan = room.scan(truth, 12.0, 0.01, random);
      scan.timestamp(micros);
      modeller.scan(
          scan,
          ScanPoses.still(
              new Sighting(
                  micros, MapFrame.of(state(told, micros)), Optional.of(state(told, micros)))));
      for (StateInformation each : modeller.corrections()) {
        worstM = Math.max(worstM, Math.hypot(each.x().orElseThrow() - x, each.y().orElseThrow()));
      }
    }
    assertThat(worstM).isLessThan(0.8);
  }

  @Test
  void scan_ofAMapSavedBefore_isFoundOnIt() {
    ScanMapModeller first = modeller(Map.of("SAVE MAP", "room.map"));
    drive(first, 0.0);
    first.end();

    ScanMapModeller second = modeller(Map.of("MAP FILE", "room.map"));
    int keys = first.keys().size();
    List<Double> errors = drive(second, 0.1);

    assertThat(errors).hasSizeGreaterThan(110).allMatch(error -> error < 0.08);
    assertThat(second.keys()).hasSize(keys);
    assertThat(second.grid(new Sighting(0L, MapFrame.BODY, Optional.empty()))).isPresent();
  }

  @Test
  void read_damagedFile_saysWhichAndWhy() throws IOException {
    ScanMapModeller first = modeller(Map.of("SAVE MAP", "room.map"));
    drive(first, 0.0);
    first.end();
    Path file = folder.resolve("room.map");
    byte[] bytes = Files.readAllBytes(file);

    for (int length = 0; length < bytes.length; length += 1 + bytes.length / 50) {
      Files.write(file, java.util.Arrays.copyOf(bytes, length));
      assertThatThrownBy(() -> MapFile.read(file))
          .isInstanceOf(BadInputException.class)
          .hasMessageContaining("room.map");
    }
  }

  @Test
  void end_fileIsNoMap_isKept() throws IOException {
    Path file = Files.writeString(folder.resolve("notes.txt"), "of somebody");
    ScanMapModeller modeller = modeller(Map.of("SAVE MAP", "notes.txt"));
    drive(modeller, 0.0);

    assertThatThrownBy(modeller::end).hasMessageContaining("notes.txt is not a map");
    assertThat(file).hasContent("of somebody");
  }

  @Test
  void end_fileIsAnOlderMapOrEmpty_isReplaced() throws IOException {
    Files.createFile(folder.resolve("room.map"));
    for (int i = 0; i < 2; i++) {
      ScanMapModeller modeller = modeller(Map.of("SAVE MAP", "room.map"));
      drive(modeller, 0.0);
      modeller.end();
      assertThat(MapFile.read(folder.resolve("room.map")).scans()).isNotEmpty();
    }
  }

  @Test
  void end_mayNotWrite_writesNothing() {
    ScanMapModeller modeller = modeller(Map.of("SAVE MAP", "room.map"), false);
    drive(modeller, 0.0);
    modeller.end();

    assertThat(folder.resolve("room.map")).doesNotExist();
  }

  @Test
  void read_scansLongerThanAllowed_isRefused() {
    ScanMapModeller first = modeller(Map.of("SAVE MAP", "room.map"));
    drive(first, 0.0);
    first.end();
    Path file = folder.resolve("room.map");

    assertThat(MapFile.read(file, 10_000_000).scans()).hasSize(first.keys().size());
    assertThatThrownBy(() -> MapFile.read(file, 1_000))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("room.map")
        .hasMessageContaining("longer than the 1000 bytes allowed");
  }
}
