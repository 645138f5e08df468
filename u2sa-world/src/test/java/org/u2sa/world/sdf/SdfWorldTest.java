package org.u2sa.world.sdf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.world.xml.WorldFile;

class SdfWorldTest {
  private static final String YARD =
      """
      <?xml version="1.0"?>
      <sdf version="1.7">
        <world name="yard">
          <physics name="ode" type="ode"><max_step_size>0.001</max_step_size></physics>
          <light name="sun" type="directional"><pose>0 0 10 0 0 0</pose></light>
          <model name="ground_plane">
            <static>true</static>
            <link name="link"><collision name="c"><geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link>
          </model>
          <model name="shed">
            <pose>10 5 0 0 0 1.5707963</pose>
            <link name="walls">
              <pose>0 0 1 0 0 0</pose>
              <collision name="c"><pose>2 0 0 0 0 0</pose><geometry><box><size>4 2 2</size></box></geometry></collision>
              <visual name="v"><geometry><box><size>40 20 2</size></box></geometry></visual>
            </link>
          </model>
          <model name="pillar">
            <pose>-3 0 0.5 0 0 0</pose>
            <link name="link"><visual name="v"><geometry><cylinder><radius>0.3</radius><length>1</length></cylinder></geometry></visual></link>
            <model name="ball">
              <pose>1 0 0 0 0 0</pose>
              <link name="link"><collision name="c"><geometry><sphere><radius>0.2</radius></sphere></geometry></collision></link>
            </model>
          </model>
          <model name="log">
            <pose degrees="true">0 -8 0.25 90 0 0</pose>
            <link name="link"><collision name="c"><geometry><cylinder><radius>0.25</radius><length>6</length></cylinder></geometry></collision></link>
          </model>
          <actor name="walker"/>
        </world>
      </sdf>
      """;

  private static final String BOX_MODEL =
      "<sdf version='1.9'><model name='hut'><static>true</static><link name='l'><collision name='c'>"
          + "<geometry><box><size>2 3 1</size></box></geometry></collision></link></model></sdf>";

  @TempDir private Path folder;

  private SdfWorld read(String text) throws IOException {
    return SdfWorld.read(Files.writeString(folder.resolve("yard.sdf"), text), Map.of());
  }

  private static <T extends ObjectDescription> T object(SdfWorld world, Class<T> kind, String uid) {
    return kind.cast(
        world.objects().stream().filter(each -> each.uid().equals(uid)).findFirst().orElseThrow());
  }

  private static final String RELATIVE =
      """
      <sdf version="1.9">
        <world name="yard">
          <model name="gate">
            <pose>10 0 0 0 0 1.5707963267948966</pose>
            <frame name="post"><pose>2 0 0 0 0 0</pose></frame>
            <link name="left"><pose relative_to="post">1 0 0 0 0 0</pose>%1$s</link>
            <frame name="top" attached_to="left"><pose>0 1 0 0 0 0</pose></frame>
            <link name="right"><pose relative_to="top">0 1 0 0 0 0</pose>%1$s</link>
          </model>
          <model name="barrel"><pose relative_to="gate">0 5 0 0 0 0</pose><link name="l">%1$s</link></model>
          %2$s
        </world>
      </sdf>
      """;
  private static final String BALL =
      "<collision name=\"c\"><geometry><sphere><radius>0.2</radius></sphere></geometry></collision>";

  @Test
  void read_posesRelativeToOtherFrames_areComposed() throws IOException {
    SdfWorld world = read(String.format(RELATIVE, BALL, ""));
    assertThat(world.ignored()).isEmpty();
    List<Point> places =
        world.objects().stream().map(each -> Point.of(each.x(), each.y(), 0.0)).toList();
    List<Point> expected =
        List.of(Point.of(10.0, 3.0, 0.0), Point.of(8.0, 3.0, 0.0), Point.of(5.0, 0.0, 0.0));
    for (int i = 0; i < expected.size(); i++) {
      assertThat(places.get(i).minus(expected.get(i)).distance()).isLessThan(1e-9);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"a", "b"})
  void read_posesRelativeInACircle_areRefused(String other) {
    String circle =
        "<model name=\"a\"><pose relative_to=\"%s\">0 0 0 0 0 0</pose></model>"
            + "<model name=\"b\"><pose relative_to=\"a\">0 0 0 0 0 0</pose></model>";
    String text = String.format(RELATIVE, BALL, String.format(circle, other));
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("in a circle");
  }

  @Test
  void read_poseRelativeToAFrameThatIsNotThere_isReported() throws IOException {
    String text =
        "<model name=\"a\"><pose relative_to=\"gone\">1 0 0 0 0 0</pose><link name=\"l\">"
            + BALL
            + "</link></model>";
    SdfWorld world = read(String.format(RELATIVE, BALL, text));
    assertThat(world.ignored()).singleElement().asString().contains("a: pose relative to gone");
  }

  @Test
  void read_posesOfWorldModelLinkAndCollision_areChained() throws IOException {
    SdfWorld world = read(YARD);

    Box shed = object(world, Box.class, "shed");
    assertThat(shed.center().distanceTo(Point.of(10.0, 7.0, 1.0))).isLessThan(1e-6);
    assertThat(shed.psi()).isCloseTo(Math.PI / 2.0, within(1e-6));
    assertThat(shed.length()).isEqualTo(4.0);
    assertThat(shed.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_ENU);
    Sphere ball = object(world, Sphere.class, "pillar/ball");
    assertThat(ball.center().distanceTo(Point.of(-2.0, 0.0, 0.5))).isLessThan(1e-9);
  }

  @Test
  void read_linkWithoutCollision_takesItsVisual() throws IOException {
    Cylinder pillar = object(read(YARD), Cylinder.class, "pillar");

    assertThat(pillar.radius()).isEqualTo(0.3);
    assertThat(pillar.center().z()).isEqualTo(0.5);
  }

  @Test
  void read_lyingCylinder_isThePrismAroundIt() throws IOException {
    Polygon log = object(read(YARD), Polygon.class, "log");

    assertThat(log.height()).isCloseTo(0.5, within(1e-6));
    assertThat(log.points().stream().mapToDouble(Point::y).min().orElseThrow())
        .isCloseTo(-11.0, within(1e-6));
    assertThat(log.points().stream().mapToDouble(Point::x).max().orElseThrow())
        .isCloseTo(0.25, within(1e-6));
    assertThat(log.distanceTo(Point.of(0.0, -5.5, 0.25))).isZero();
    assertThat(log.distanceTo(Point.of(0.0, -4.0, 0.25))).isCloseTo(1.0, within(1e-6));
  }

  @Test
  void read_whatIsNoObject_isListed() throws IOException {
    assertThat(read(YARD).ignored())
        .anyMatch(words -> words.startsWith("ground_plane") && words.contains("plane"))
        .anyMatch(words -> words.startsWith("actor in line"))
        .hasSize(2);
  }

  @Test
  void missing_planeAndActorAndLostMesh_areWhatMayStandInTheWay() throws IOException {
    assertThat(read(YARD).missing())
        .singleElement()
        .asString()
        .startsWith("actor in line"); // not the ground plane
    String house =
        "<sdf version='1.9'><world name='w'><model name='house'><link name='l'><collision name='c'>"
            + "<geometry><mesh><uri>hause.stl</uri></mesh></geometry></collision></link></model>"
            + "<model name='sun'><link name='l'><visual name='v'><geometry><empty/></geometry>"
            + "</visual></link></model></world></sdf>";
    assertThat(read(house).missing()).containsExactly("house/l: mesh hause.stl is not found");
    assertThat(read(house).ignored()).hasSize(2);
  }

  @ParameterizedTest
  @ValueSource(strings = {"models/hut", "models/hut/model.sdf"})
  void read_modelBehindALinkOutOfTheFolder_isNotRead(String link, @TempDir Path elsewhere)
      throws IOException {
    Path hut = Files.createDirectory(elsewhere.resolve("hut"));
    Path model = Files.writeString(hut.resolve("model.sdf"), BOX_MODEL);
    Path place = folder.resolve(link);
    Files.createDirectories(place.getParent());
    Files.createSymbolicLink(place, link.endsWith("sdf") ? model : hut);
    String world =
        "<sdf version='1.9'><world name='w'><include><uri>model://hut</uri></include></world></sdf>";

    assertThat(read(world).objects()).isEmpty();
    assertThat(read(world).ignored()).containsExactly("hut: model model://hut is not found");

    Files.delete(place);
    Files.createDirectories(folder.resolve("models/hut"));
    Files.writeString(folder.resolve("models/hut/model.sdf"), BOX_MODEL);
    assertThat(read(world).objects()).hasSize(1);
  }

  @Test
  void load_byWorldFile_givesTheSameObjects() throws IOException {
    SdfWorld world = read(YARD);

    WorldFile loaded = WorldFile.load(folder.resolve("yard.sdf"));

    assertThat(loaded.objects()).isEqualTo(world.objects());
    assertThat(loaded.ignored()).isEqualTo(world.ignored());
    assertThat(loaded.missing()).isEqualTo(world.missing());
  }

  @Test
  void read_includeAndMesh_areFoundAmongTheModels() throws IOException {
    Path model = Files.createDirectories(folder.resolve("models/buoy/meshes"));
    Files.writeString(
        folder.resolve("models/buoy/model.sdf"),
        """
        <sdf version="1.6"><model name="buoy"><link name="l"><collision name="c"><geometry>
          <mesh><uri>model://buoy/meshes/tetra.stl</uri><scale>2 2 2</scale></mesh>
        </geometry></collision></link></model></sdf>
        """);
    Files.write(
        model.resolve("tetra.stl"), stl(Point.of(0, 0, 0), Point.of(1, 0, 0), Point.of(0, 1, 1)));

    SdfWorld world =
        read(
            """
            <sdf version="1.6"><world name="w">
              <include><uri>model://buoy</uri><name>red</name><pose>100 0 0 0 0 0</pose></include>
              <include><uri>model://nobody</uri></include>
              <include><uri>../../../../../../etc</uri></include>
            </world></sdf>
            """);

    Polygon red = object(world, Polygon.class, "red");
    assertThat(red.height()).isCloseTo(2.0, within(1e-6));
    assertThat(red.points()).hasSize(3).contains(Point.of(102.0, 0.0, 0.0));
    assertThat(world.ignored())
        .containsExactly(
            "nobody: model model://nobody is not found",
            "etc: model ../../../../../../etc is not found");
  }

  @Test
  void read_modelsThatIncludeEachOtherByTheThousand_areRefusedSoon() throws IOException {
    for (int level = 0; level < 7; level++) {
      Path model = Files.createDirectories(folder.resolve("models/m" + level));
      String include = "<include><uri>model://m" + (level + 1) + "</uri></include>";
      Files.writeString(
          model.resolve("model.sdf"),
          "<sdf version=\"1.9\"><model name=\"m\">" + include.repeat(30) + "</model></sdf>");
    }
    String world =
        "<sdf version=\"1.9\"><world name=\"w\"><include><uri>model://m0</uri></include></world></sdf>";

    assertTimeoutPreemptively(
        Duration.ofMinutes(10),
        () ->
            assertThatThrownBy(() -> read(world))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("as often as it is included"));
  }

  private static byte[] stl(Point... corners) {
    ByteBuffer bytes = ByteBuffer.allocate(84 + 50).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putInt(80, 1);
    bytes.position(84 + 12);
    for (Point each : corners) {
      bytes.putFloat((float) each.x()).putFloat((float) each.y()).putFloat((float) each.z());
    }
    return bytes.array();
  }

  @Test
  void read_savedState_putsModelsWhereTheyWere() throws IOException {
    SdfWorld world =
        read(
            """
            <sdf version="1.6"><world name="w">
              <model name="can"><pose>1 2 0 0 0 0</pose><link name="l"><collision name="c">
                <geometry><sphere><radius>1</radius></sphere></geometry></collision></link></model>
              <state world_name="w"><model name="can"><pose>7 8 0 0 0 0</pose></model></state>
            </world></sdf>
            """);

    assertThat(world.objects().get(0).center()).isEqualTo(Point.of(7.0, 8.0, 0.0));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<box><size>1 2</size></box> | expected 3 numbers",
        "<box><size>1 2 -1</size></box> | expected numbers above 0",
        "<cylinder><radius>x</radius><length>1</length></cylinder> | \"x\" is not a number",
        "<cylinder><length>1</length></cylinder> | lacks <radius>",
        "<sphere><radius>1e300</radius></sphere> | 10,000,000"
      })
  void read_invalidGeometry_namesFileLineAndWhatWasExpected(String shape, String words) {
    String text =
        "<sdf version='1.6'><world name='w'><model name='m'><link name='l'><collision name='c'>\n<geometry>"
            + shape
            + "</geometry></collision></link></model></world></sdf>";
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("yard.sdf")
        .hasMessageContaining("line 2")
        .hasMessageContaining(words);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void read_damagedAnywhere_isReadOrRefusedInWords(long seed) {
    Random random = new Random(seed);
    byte[] sound = YARD.getBytes(StandardCharsets.UTF_8);
    int refused = 0;
    for (int i = 0; i < 250; i++) {
      byte[] damaged = sound.clone();
      for (int k = 0; k <= random.nextInt(4); k++) {
        damaged[random.nextInt(damaged.length)] = (byte) (32 + random.nextInt(95));
      }
      try {
        read(new String(damaged, StandardCharsets.UTF_8));
      } catch (BadInputException e) {
        assertThat(e).hasMessageContaining("yard.sdf");
        refused++;
      } catch (IOException e) {
        throw new AssertionError(e);
      }
    }
    assertThat(refused).isBetween(50, 249);
  }
}
