package org.u2sa.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.testkit.ServiceKit;

/** One thing that two sensors see: a camera knows what it is, a scanner where. */
class CameraAndScannerTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private static Circle seen(String sensor, String type, double x, double y, double sigma) {
    Circle circle = new Circle().radius(0.3);
    circle
        .uid(sensor + " 1")
        .objectType(type)
        .referenceFrame(ReferenceFrame.BODY)
        .x(x)
        .y(y)
        .sensorName(sensor);
    circle.motion().sigma(Point.of(sigma, sigma, 0.0));
    return circle;
  }

  private void tick(ObjectDescription... objects) {
    StateInformation state =
        new StateInformation().sensorName("E").referenceFrame(ReferenceFrame.LOCAL_NED);
    kit.send(Channels.STATE, state.x(0.0).y(0.0).psi(0.0));
    for (ObjectDescription each : objects) {
      kit.send(Channels.SENSED_OBJECTS, each);
    }
    kit.settle();
    kit.advance(0.1);
  }

  private List<ObjectDescription> objects() {
    return kit.latest(Channels.OBJECTS).orElseThrow().objects();
  }

  @Test
  void objects_cameraAndScanner_areOneOfTheCamerasTypeAtTheScannersPlace() {
    kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      ObjectDescription camera = seen("Camera", "barrel", 5.5, 0.2, 0.5);
      camera.level(ObjectLevel.AVOID_ALWAYS);
      tick(camera);
      tick(seen("Lidar objects", "", 5.0, 0.0, 0.02));
    }
    assertThat(objects()).hasSize(1);
    ObjectDescription one = objects().get(0);
    assertThat(one.objectType()).isEqualTo("barrel");
    assertThat(one.level()).hasValue(ObjectLevel.AVOID_ALWAYS);
    assertThat(one.x()).isCloseTo(5.0, within(0.03)); // north, from the origin
    assertThat(one.y()).isCloseTo(0.0, within(0.03));
  }

  @Test
  void objects_camerasTypesDiffer_stayTwoBesideEachOther() {
    kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      tick(
          seen("Camera", "barrel", 5.0, 0.0, 0.2),
          seen("Camera", "red flag", 5.3, 0.3, 0.2).uid("Camera 2"));
      tick(seen("Lidar objects", "", 5.0, 0.0, 0.02));
    }
    assertThat(objects())
        .extracting(ObjectDescription::objectType)
        .containsExactlyInAnyOrder("barrel", "red flag");
  }

  @Test
  void objects_flatBehindWhatAScannerSees_isPartOfThat() {
    kit.with("MODELLERS", "OBJECTS").with("FLAT TYPES", "pothole").start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      kit.send(Channels.SCANS, ModelledWorld.wallAhead(2.0));
      tick(seen("Camera", "pothole", 4.0, 0.0, 0.1), seen("Camera", "barrel", 4.0, 0.1, 0.1));
    }
    assertThat(objects()).extracting(ObjectDescription::objectType).containsExactly("barrel");
  }

  @Test
  void objects_flatBesideWhatAScannerSees_isEntered() {
    kit.with("MODELLERS", "OBJECTS").with("FLAT TYPES", "pothole").start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      kit.send(Channels.SCANS, ModelledWorld.wallAhead(2.0));
      tick(seen("Camera", "pothole", 4.0, 3.0, 0.1));
    }
    assertThat(objects()).extracting(ObjectDescription::objectType).containsExactly("pothole");
  }

  @Test
  void objects_flatOneHiddenByNow_isNotDoubted() {
    kit.with("MODELLERS", "OBJECTS")
        .with("FLAT TYPES", "pothole")
        .with("FIELDS OF VIEW", "Camera: 60 deg, 8 m")
        .start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      tick(seen("Camera", "pothole", 4.0, 0.0, 0.1));
    }
    for (int i = 0; i < 20; i++) {
      kit.send(Channels.SCANS, ModelledWorld.wallAhead(2.0));
      tick(seen("Camera", "barrel", 2.0, 0.0, 0.1));
    }
    assertThat(objects()).extracting(ObjectDescription::objectType).contains("pothole");
  }
}
