package org.u2sa.trials.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.marine.BlueRov2;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.XmlMutations;
import org.u2sa.world.xml.WorldFile;

/**
 * Mutated world files, of U2SA and Gazebo: each ends in an error that names the file, or in a world
 * in which a vessel moves. {@code -Du2sa.fuzz=10000} makes more of them.
 */
class WorldFileFuzzTest {
  private static final int MUTATIONS = Integer.getInteger("u2sa.fuzz", 400);
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

  private static final List<String> SDF_TAGS =
      List.of("pose", "model", "link", "collision", "box", "sphere", "size", "state", "include");

  private static final String SDF =
      """
      <sdf version="1.7">
        <world name="yard">
          <model name="ground"><link name="l"><collision name="c">
            <geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model>
          <model name="shed">
            <pose>10 5 0 0 0 1.57</pose>
            <link name="walls"><pose>0 0 1 0 0 0</pose>
              <collision name="c"><pose>2 0 0 0 0 0</pose>
                <geometry><box><size>4 2 2</size></box></geometry></collision></link>
            <model name="ball"><pose>1 0 0 0 0 0</pose><link name="l"><visual name="v">
              <geometry><sphere><radius>0.2</radius></sphere></geometry></visual></link></model>
          </model>
          <model name="log"><pose degrees="true">0 -8 0.25 90 0 0</pose><link name="l">
            <collision name="c"><geometry><cylinder><radius>0.25</radius><length>6</length></cylinder></geometry></collision>
            <collision name="d"><geometry><capsule><radius>0.3</radius><length>2</length></capsule></geometry></collision>
            <collision name="e"><geometry><polyline><point>0 0</point><point>3 0</point><point>0 2</point><height>1</height></polyline></geometry></collision>
          </link></model>
          <include><uri>model://nobody</uri><pose>1 2 3 0 0 0</pose></include>
          <state world_name="yard"><model name="log"><pose>7 8 0 0 0 0</pose></model></state>
        </world>
      </sdf>
      """;

  @TempDir private Path folder;

  /** Whether the file is a world in which a vessel moves; false if it is refused. */
  private boolean runs(String name, String text) throws IOException {
    Path file = folder.resolve(name);
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

  @ParameterizedTest
  @ValueSource(strings = {"world.xml", "world.sdf"})
  void read_mutatedFiles_runOrAreRefusedWithTheirName(String name) throws IOException {
    boolean sdf = name.endsWith("sdf");
    String original = sdf ? SDF : WORLD;
    XmlMutations mutations = new XmlMutations(21L, sdf ? SDF_TAGS : TAGS, List.of("regular"));
    assertThat(runs(name, original)).isTrue();
    int running = 0;
    for (int i = 0; i < MUTATIONS; i++) {
      String mutant = mutations.of(original);
      try {
        running += runs(name, mutant) ? 1 : 0;
      } catch (RuntimeException | AssertionError e) {
        throw new AssertionError("mutant " + i + ":\n" + mutant, e);
      }
    }
    assertThat(running).isBetween(MUTATIONS / 20, MUTATIONS - MUTATIONS / 20);
  }
}
