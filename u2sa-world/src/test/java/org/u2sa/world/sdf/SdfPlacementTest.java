package org.u2sa.world.sdf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Box;

class SdfPlacementTest {
  private static final String LINK =
      "<link name='l'><pose>1 0 0 0 0 0</pose><collision name='c'><geometry><box><size>2 1 1</size></box>"
          + "</geometry></collision></link>";
  private static final String HOOK =
      "<frame name='hook'><pose>3 0 0 0 0 1.5707963267948966</pose></frame>";

  /** In its placement frame, the box stands at (0, 2), its length along y. */
  private static final String HUNG =
      "<model name='hung' placement_frame='hook'>%s" + HOOK + LINK + "</model>";

  @TempDir private Path folder;

  private SdfWorld read(String world) throws IOException {
    String text = "<sdf version='1.9'><world name='w'>" + world + "</world></sdf>";
    return SdfWorld.read(Files.writeString(folder.resolve("w.sdf"), text), Map.of());
  }

  private void model(String name, String content) throws IOException {
    Path model = Files.createDirectories(folder.resolve("models/" + name));
    Files.writeString(model.resolve("model.sdf"), "<sdf version='1.9'>" + content + "</sdf>");
  }

  private static void assertBox(ObjectDescription object, double x, double y, double turn) {
    assertThat(object.center().distanceTo(Point.of(x, y, 0.0))).isLessThan(1e-6);
    double off = ((Box) object).psi() - turn;
    assertThat(Math.sin(off)).isCloseTo(0.0, within(1e-6)); // a box looks the same from behind
  }

  @Test
  void read_placementFrame_isWhereThePoseIs() throws IOException {
    String pose = "<pose>10 20 0 0 0 0</pose>";

    assertBox(read(String.format(HUNG, pose)).objects().get(0), 10.0, 22.0, Math.PI / 2.0);
  }

  @Test
  void read_poseRelativeToAModelWithPlacementFrame_isRelativeToTheModel() throws IOException {
    String beside =
        "<model name='b'><pose relative_to='hung'>0 0 0 0 0 0</pose>" + LINK + "</model>";
    SdfWorld world = read(String.format(HUNG, "<pose>10 20 0 0 0 0</pose>") + beside);

    assertBox(world.objects().get(1), 10.0, 22.0, Math.PI / 2.0);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<pose>10 20 0 0 0 0</pose> | 11 | 20 | 0",
        "<pose>10 20 0 0 0 0</pose><placement_frame>hook</placement_frame> | 10 | 22 | 90",
        "<pose>10 20 0 0 0 0</pose><placement_frame>part::l</placement_frame> | 5 | 20 | 0",
        " | 8 | 7 | 0"
      })
  void read_include_hasItsOwnPoseAndPlacement(String placement, double x, double y, double deg)
      throws IOException {
    String part =
        "<model name='part'><pose>5 0 0 0 0 0</pose><link name='l'><pose>1 0 0 0 0 0</pose></link></model>";
    model("crate", "<model name='box'><pose>7 7 0 0 0 0</pose>" + HOOK + LINK + part + "</model>");
    String given = placement == null ? "" : placement;
    SdfWorld world = read("<include><uri>model://crate</uri>" + given + "</include>");

    assertThat(world.ignored()).isEmpty();
    assertBox(world.objects().get(0), x, y, Math.toRadians(deg));
    assertThat(world.objects().get(0).uid()).isEqualTo("box");
  }

  @Test
  void read_poseRelativeToAnIncludedModel_isFound() throws IOException {
    model("crate", "<model name='box'><pose>7 7 0 0 0 0</pose>" + HOOK + LINK + "</model>");
    String include = "<include><uri>model://crate</uri>%s</include>";
    String beside =
        "<model name='b'><pose relative_to='%s::hook'>0 0 0 0 0 0</pose>" + LINK + "</model>";
    SdfWorld world =
        read(
            String.format(include, "")
                + String.format(include, "<name>two</name><pose>1 2 0 0 0 0</pose>")
                + String.format(beside, "box")
                + String.format(beside, "two"));

    assertThat(world.ignored()).isEmpty();
    assertThat(world.objects()).extracting(ObjectDescription::uid).startsWith("box", "two");
    assertBox(world.objects().get(2), 10.0, 8.0, Math.PI / 2.0);
    assertBox(world.objects().get(3), 4.0, 3.0, Math.PI / 2.0);
  }

  @Test
  void read_placementFrameThatIsNotThere_isReported() throws IOException {
    model("crate", "<model name='box'>" + LINK + "</model>");
    String include =
        "<include><uri>model://crate</uri><pose/><placement_frame>gone</placement_frame></include>";

    assertThat(read(include).ignored())
        .containsExactly("box: pose relative to gone, which is not found");
  }

  @Test
  void read_placementFrameOfAnIncludeWithoutPose_isRefused() throws IOException {
    model("crate", "<model name='box'>" + HOOK + LINK + "</model>");
    String include =
        "<include><uri>model://crate</uri><placement_frame>hook</placement_frame></include>";

    assertThatThrownBy(() -> read(include))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("w.sdf, line 1, <placement_frame>: expected <pose> beside it");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<pose rotation_format='quat_xyzw'>1 2 0 0 0 0.3826834 0.9238795</pose> | 45",
        "<pose rotation_format='quat_xyzw'>1 2 0 0 0 -2 2</pose> | -90",
        "<pose rotation_format='quat_xyzw'>1 2 0 1 0 0 0</pose> | 0",
        "<pose rotation_format='euler_rpy' degrees='1'>1 2 0 0 0 30</pose> | 30",
        "<pose degrees='false'>1 2 0 0 0 0.5</pose> | 28.6478898",
      })
  void read_rotationFormats_areUnderstood(String pose, double degrees) throws IOException {
    String centred = LINK.replace("1 0 0 0 0 0", "");
    SdfWorld world = read("<model name='q'>" + pose + centred + "</model>");

    assertBox(world.objects().get(0), 1.0, 2.0, Math.toRadians(degrees));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<pose rotation_format='quat_xyzw'>1 2 0 0 0 0</pose> | expected 7 numbers",
        "<pose>1 2 0 0 0 0 1</pose> | expected 6 numbers",
        "<pose rotation_format='quat_xyzw'>1 2 0 0 0 0 0</pose> | a quaternion other than 0 0 0 0",
        "<pose rotation_format='axis'>1 2 0 0 0 0</pose> | expected euler_rpy or quat_xyzw",
        "<pose rotation_format='quat_xyzw' degrees='true'>1 2 0 0 0 0 1</pose> | expected no degrees"
      })
  void read_falseRotation_isRefusedInWords(String pose, String words) {
    assertThatThrownBy(() -> read("<model name='q'>" + pose + LINK + "</model>"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("w.sdf, line 1, <pose>")
        .hasMessageContaining(words);
  }

  @Test
  void read_severalPolylines_areOneOutline() throws IOException {
    String points =
        "<point>%1$d 0</point><point>%2$d 0</point><point>%1$d 5</point><height>2</height>";
    String hole = "<polyline>" + String.format(points, 1, 2) + "</polyline>";
    String outer = "<polyline>" + String.format(points, 0, 9) + "</polyline>";
    String model = LINK.replace("<box><size>2 1 1</size></box>", hole + outer);
    List<ObjectDescription> objects = read("<model name='p'>" + model + "</model>").objects();

    assertThat(objects).hasSize(1);
    assertThat(objects.get(0).distanceTo(Point.of(10.0, 0.0, 1.0))).isLessThan(1e-6);
  }
}
