package org.u2sa.world.sdf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Polygon;

class SdfMeshTest {
  /** A tetrahedron of 4 x 2 x 3 units from the origin, and a position that no face uses. */
  private static final String DAE =
      """
      <?xml version="1.0" encoding="utf-8"?>
      <COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
        <asset>%s<up_axis>Y_UP</up_axis></asset>
        <library_geometries>
          <geometry id="g"><mesh>
            <source id="positions">
              <float_array id="array" count="15">0 0 0 4 0 0 0 2 0 0 0 3 900 900 900</float_array>
            </source>
            <vertices id="v"><input semantic="POSITION" source="#positions"/></vertices>
            <triangles count="2">
              <input semantic="NORMAL" source="#normals" offset="0"/>
              <input semantic="VERTEX" source="#v" offset="1"/>
              <p>4 0 4 1 4 2 4 1 4 2 4 3</p>
            </triangles>
          </mesh></geometry>
          <geometry id="elsewhere"><mesh>
            <source id="far"><float_array count="9">70 0 0 80 0 0 0 90 90</float_array></source>
            <vertices id="w"><input semantic="POSITION" source="#far"/></vertices>
            <triangles count="1"><input semantic="VERTEX" source="#w" offset="0"/><p>0 1 2</p></triangles>
          </mesh></geometry>
        </library_geometries>
        <library_controllers><controller id="c"><skin source="#g"/></controller></library_controllers>
        <library_nodes>
          <node id="shelf" name="shelf"><translate>0 0 10</translate><instance_geometry url="#g"/></node>
        </library_nodes>
        <library_visual_scenes>
          <visual_scene id="other"><node><instance_geometry url="#elsewhere"/></node></visual_scene>
          <visual_scene id="s">%s</visual_scene>
        </library_visual_scenes>
        <scene><instance_visual_scene url="#s"/></scene>
      </COLLADA>
      """;

  private static final String INSTANCE = "<instance_geometry url=\"#g\"/>";

  @TempDir private Path folder;

  private SdfWorld read(String file, String content, String more) throws IOException {
    Files.writeString(folder.resolve(file), content);
    return world(file, more);
  }

  private SdfWorld world(String file, String more) throws IOException {
    String text =
        "<sdf version=\"1.9\"><model name=\"m\"><link name=\"l\"><collision name=\"c\"><geometry><mesh><uri>"
            + file
            + "</uri>"
            + more
            + "</mesh></geometry></collision></link></model></sdf>";
    return SdfWorld.read(Files.writeString(folder.resolve("yard.sdf"), text), Map.of());
  }

  /** Bounds of the only object in hundredths: the lowest x, y, z and the highest. */
  private static List<Long> box(SdfWorld world) {
    assertThat(world.ignored()).isEmpty();
    assertThat(world.objects()).hasSize(1);
    Polygon mesh = (Polygon) world.objects().get(0);
    double bottom = mesh.center().z() - mesh.height() / 2.0;
    return DoubleStream.of(
            min(mesh, Point::x),
            min(mesh, Point::y),
            bottom,
            -min(mesh, p -> -p.x()),
            -min(mesh, p -> -p.y()),
            bottom + mesh.height())
        .mapToObj(each -> Math.round(100.0 * each))
        .toList();
  }

  private static double min(Polygon mesh, ToDoubleFunction<Point> coordinate) {
    return mesh.points().stream().mapToDouble(coordinate).min().orElseThrow();
  }

  private static List<Long> hundredths(String numbers) {
    return Stream.of(numbers.split(" "))
        .map(each -> Math.round(100.0 * Double.parseDouble(each)))
        .toList();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        " | <node>G</node> | 0 0 0 4 2 3",
        "<unit name='inch' meter='0.0254'/> | <node><matrix>1 0 0 100 0 1 0 0 0 0 1 0 0 0 0 1</matrix>G</node>"
            + " | 2.54 0 0 2.64 0.05 0.08",
        " | <node><matrix>0 -2 0 7 2 0 0 8 0 0 2 9 0 0 0 1</matrix>G</node> | 3 8 9 7 16 15",
        " | <node><translate>1 2 3</translate><rotate>0 0 5 90</rotate><scale>1 1 2</scale>G</node>"
            + " | -1 2 3 1 6 9",
        " | <node><rotate>0 0 1 90</rotate><translate>1 2 3</translate>G</node> | -4 1 3 -2 5 6",
        " | <node><rotate>0 0 1 90</rotate><rotate>1 0 0 90</rotate>G</node> | 0 0 0 3 4 2",
        " | <node><scale>2 2 2</scale><node><translate>1 0 0</translate>G</node></node> | 2 0 0 10 4 6",
        " | <node>G</node><node><translate>0 20 0</translate>G</node> | 0 0 0 4 22 3",
        " | <node><translate>1 0 0</translate><instance_node url='#shelf'/></node> | 1 0 10 5 2 13",
        " | <node><translate>1 0 0</translate><instance_controller url='#c'/></node> | 1 0 0 5 2 3",
        " | <node><translate>5 0 0</translate></node><node>G</node> | 0 0 0 4 2 3",
      })
  void read_colladaScene_placesEachInstance(String unit, String nodes, String expected)
      throws IOException {
    String scene = nodes.replace("G", INSTANCE);
    SdfWorld world = read("m.dae", String.format(DAE, unit == null ? "" : unit, scene), "");

    assertThat(box(world)).isEqualTo(hundredths(expected));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<node><skew>0 1 0 0 0 1 0</skew>G</node> | <skew>: expected <matrix>, <translate>, <rotate>",
        "<node><instance_geometry url='#no'/></node> | \"#no\": expected # and the id of a <geometry>",
        "<node><matrix>1 0 0</matrix>G</node> | <matrix>: \"1 0 0\": expected 16 numbers",
        "<node><rotate>0 0 0 9</rotate>G</node> | expected an axis other than 0 0 0",
        "<node id='a'><instance_node url='#a'/></node> | nested deeper than 64, or in a circle",
        "<node name='empty'/> | has no corners"
      })
  void read_colladaThatCannotBePlaced_isReportedByElement(String nodes, String words)
      throws IOException {
    SdfWorld world = read("m.dae", String.format(DAE, "", nodes.replace("G", INSTANCE)), "");

    assertThat(world.objects()).isEmpty();
    assertThat(world.ignored())
        .singleElement()
        .asString()
        .startsWith("m/l: mesh m.dae: ")
        .contains(words);
  }

  @Test
  void read_colladaNodesThatMultiply_areRefusedSoon() throws IOException {
    StringBuilder nodes = new StringBuilder();
    for (int level = 0; level < 12; level++) {
      String next = "<instance_node url=\"#n" + (level + 1) + "\"/>";
      nodes.append("<node id=\"n" + level + "\">" + next.repeat(30) + "</node>");
    }
    nodes.append("<node id=\"n12\"/>");

    SdfWorld world =
        assertTimeoutPreemptively(
            Duration.ofMinutes(10), () -> read("m.dae", String.format(DAE, "", nodes), ""));

    assertThat(world.ignored()).singleElement().asString().contains("exceed 512 MB");
  }

  @Test
  void read_colladaWhoseTagsDoNotEnd_isReportedSoon() throws IOException {
    SdfWorld world =
        assertTimeoutPreemptively(
            Duration.ofMinutes(10), () -> read("evil.dae", "<float_array".repeat(400_000), ""));

    assertThat(world.ignored()).singleElement().asString().contains("evil.dae, line 1");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "right | false | 20 0 0 24 2 3",
        "right | true | -2 -1 -1.5 2 1 1.5",
        "left | 0 | 0 0 0 4 2 3"
      })
  void read_submesh_isThatNodeOnlyAndCentredIfAsked(String name, String center, String expected)
      throws IOException {
    String nodes =
        String.format(
            "<node name=\"left\">%1$s</node><node name=\"right\"><translate>20 0 0</translate><node>%1$s</node></node>",
            INSTANCE);
    String submesh = "<submesh><name>" + name + "</name><center>" + center + "</center></submesh>";

    SdfWorld world = read("m.dae", String.format(DAE, "", nodes), submesh);

    assertThat(box(world)).isEqualTo(hundredths(expected));
  }

  @Test
  void read_submeshThatIsNotThere_isReported() throws IOException {
    String nodes = "<node name=\"left\">" + INSTANCE + "</node>";
    SdfWorld world =
        read("m.dae", String.format(DAE, "", nodes), "<submesh><name>roof</name></submesh>");

    assertThat(world.ignored()).containsExactly("m/l: mesh m.dae, submesh roof: has no corners");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "v 0 0 0\\nv 4 0 0\\nv 0 2 3\\nf 1 2 3 | .obj",
        "v 0 0 0\\nv 4 0 0\\nv 0 2 3\\nv 9 9 9\\nv 8 8 8\\nf 1/7/1 \\\\n2//2 3/9 | .obj",
        "v 9 9 9\\r\\nv 0 0 0\\r\\nv 4 0 0 1.0\\r\\nv  0 2 3\\r\\n  f -3 -2/1 -1//1\\r\\nv 7 7 7 | .obj",
        "solid a\\nvertex 0 0 0\\nvertex 4 0 0\\nvertex 0 2 3\\nendsolid | .stl",
        "SOLID a\\nVERTEX 0 0 0\\nVERTEX 4 0 0\\nVERTEX 0 2 3\\nENDSOLID | .stl",
      })
  void read_meshOfEachFormat_hasTheCornersOfItsFaces(String text, String ending)
      throws IOException {
    String content = text.replace("\\n", "\n").replace("\\r", "\r");

    assertThat(box(read("mesh" + ending, content, ""))).isEqualTo(hundredths("0 0 0 4 2 3"));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 7})
  void read_binaryStl_mayHaveMoreBehindIt(int more) throws IOException {
    ByteBuffer stl = ByteBuffer.allocate(84 + 50 + more).order(ByteOrder.LITTLE_ENDIAN);
    stl.putInt(80, 1).position(84 + 12);
    for (float each : new float[] {0, 0, 0, 4, 0, 0, 0, 2, 3}) {
      stl.putFloat(each);
    }
    Files.write(folder.resolve("m.stl"), stl.array());

    assertThat(box(world("m.stl", "<scale>1 -1 2</scale>"))).isEqualTo(hundredths("0 -2 0 4 0 6"));
  }

  @Test
  void read_submeshOfObj_isItsGroup() throws IOException {
    String obj =
        "v 0 0 0\nv 4 0 0\nv 0 2 3\nv 50 0 0\nv 50 9 9\no house\nf 1 2 3\ng roof\nf 3 4 5\n";

    assertThat(box(read("m.obj", obj, "<submesh><name>house</name></submesh>")))
        .isEqualTo(hundredths("0 0 0 4 2 3"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "v 0 0\\n | line 1: expected v and three numbers",
        "v 0 0 0\\nf 1 2 3 | line 2: \"2\": expected the number of one of 1 vertices",
        "v 0 0 0\\nf -2 1 1 | line 2: \"-2\": expected",
        "v 0 1e999 0 | line 1: has a corner with invalid coordinates",
        "v 0 0 0 | has no corners"
      })
  void read_falseObj_isReportedByLine(String text, String words) throws IOException {
    SdfWorld world = read("m.obj", text.replace("\\n", "\n"), "");

    assertThat(world.ignored()).singleElement().asString().contains("mesh m.obj: " + words);
  }
}
