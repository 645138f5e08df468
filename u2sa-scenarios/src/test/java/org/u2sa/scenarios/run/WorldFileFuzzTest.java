package org.u2sa.scenarios.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.marine.BlueRov2;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;
import org.u2sa.world.xml.WorldFile;

/**
 * Mutated world files: each ends in an error that names the file, or in a world in which a vessel
 * moves. {@code -Du2sa.fuzz=10000} makes more of them.
 */
class WorldFileFuzzTest {
  private static final int MUTATIONS = Integer.getInteger("u2sa.fuzz", 400);
  private static final Pattern NUMBER = Pattern.compile("(?<=>|\\s)-?\\d+(\\.\\d+)?(?=<|\\s|;)");
  private static final Pattern TAG = Pattern.compile("</?\\w+");
  private static final Pattern WORD = Pattern.compile("(?<=>)[a-zA-Z][a-zA-Z -]*(?=<)");
  private static final List<String> ODD =
      List.of(
          "0", "-1", "1e-12", "1e12", "1e308", "NaN", "Infinity", "", "1 2", "x", "0.5", "-1e9");
  private static final List<String> TAGS =
      List.of("mover", "zone", "waves", "speed", "waypoint", "water", "polygon");

  private static final String WORLD =
      """
      <world>
        <reference>Local ENU</reference>
        <environment>
          <surface>lawn</surface>
          <water>
            <level>0.5</level>
            <currents><columns>2</columns><width>40</width><depth>40</depth>
              <east>0 1 0 1</east><north>0 0 0.5 0.5</north></currents>
            <profile>0 1; 10 0.5; 20 0</profile>
            <waves><spectrum>jonswap</spectrum><height>0.4</height><period>3</period>
              <towards unit="deg">90</towards><spread>0.3</spread></waves>
          </water>
          <wind><speed>5</speed><from unit="deg">270</from><roughness>0.03</roughness><reference>10</reference></wind>
          <light><azimuth>2</azimuth><elevation>0.7</elevation><brightness>0.8</brightness></light>
        </environment>
        <mover>
          <box><uid>ferry</uid><x>4</x><y>-9</y><z>0</z><length>8</length><width>3</width><height>2</height></box>
          <waypoint><x>4</x><y>9</y><wait>2</wait></waypoint>
          <waypoint><x>9</x><y>9</y><speed>2</speed></waypoint>
          <speed unit="kt">4</speed>
          <delay>1</delay>
          <end>loop</end>
          <floats>true</floats>
        </mover>
        <zone>
          <kind>patch</kind>
          <polygon><uid>sand</uid><points>-3 3; 3 3; 3 7; -3 7</points></polygon>
          <surface><grip>0.5</grip><rollingResistance>0.1</rollingResistance></surface>
        </zone>
        <Circle><uid>buoy</uid><x>4</x><y>8</y></Circle>
      </world>
      """;

  @TempDir private Path folder;

  private final Random random = new Random(21);

  private String mutated(String text) {
    String mutant = text;
    for (int i = 0; i <= random.nextInt(3); i++) {
      mutant =
          switch (random.nextInt(6)) {
            case 0, 1 -> replaced(mutant, NUMBER, ODD.get(random.nextInt(ODD.size())));
            case 2 -> replaced(mutant, NUMBER, "" + Math.exp(20.0 * random.nextGaussian()));
            case 3 -> replaced(mutant, TAG, "<" + TAGS.get(random.nextInt(TAGS.size())));
            case 4 -> replaced(mutant, WORD, "regular");
            default -> cut(mutant);
          };
    }
    return mutant;
  }

  private String replaced(String text, Pattern what, String by) {
    List<int[]> found = new ArrayList<>();
    Matcher matcher = what.matcher(text);
    while (matcher.find()) {
      found.add(new int[] {matcher.start(), matcher.end()});
    }
    if (found.isEmpty()) {
      return text;
    }
    int[] one = found.get(random.nextInt(found.size()));
    return text.substring(0, one[0]) + by + text.substring(one[1]);
  }

  private String cut(String text) {
    int from = random.nextInt(text.length());
    int to = Math.min(text.length(), from + 1 + random.nextInt(60));
    return text.substring(0, from) + text.substring(to);
  }

  /** Whether the file is a world in which a vessel moves; false if it is refused. */
  private boolean runs(String text) throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(file, text);
    try {
      World empty = World.at(new Geodetic(9.0, 54.0, 0.0)).with(new Water(0.0, 0.0, 0.0));
      World world = SimulatedWorld.read(WorldFile.load(file), file, empty, 1L);
      VehicleRun run = new VehicleRun(BlueRov2.at(world, Point.of(0.0, 0.0, -3.0), 0.0));
      run.at(0L);
      assertThat(run.at(2_000_000L).speedMps()).isFinite();
      assertThat(world.when(2.0).distanceM(Ray.of(Point.of(0.0, 0.0, 1.0), 1.0, 0.0), 50.0))
          .isNotNaN();
      assertThat(world.surface().grip(0.0, 5.0)).isPositive();
      assertThat(SimulatedWorld.surroundings(world, 60.0).objects())
          .hasSameSizeAs(world.when(0.0).obstacles());
      return true;
    } catch (BadInputException e) {
      assertThat(e.getMessage()).startsWith(file.toString());
      return false;
    }
  }

  @Test
  void read_mutatedFiles_runOrAreRefusedWithTheirName() throws IOException {
    assertThat(runs(WORLD)).isTrue();
    int running = 0;
    for (int i = 0; i < MUTATIONS; i++) {
      String mutant = mutated(WORLD);
      try {
        running += runs(mutant) ? 1 : 0;
      } catch (RuntimeException | AssertionError e) {
        throw new AssertionError("mutant " + i + ":\n" + mutant, e);
      }
    }
    assertThat(running).isBetween(MUTATIONS / 20, MUTATIONS - MUTATIONS / 20);
  }
}
