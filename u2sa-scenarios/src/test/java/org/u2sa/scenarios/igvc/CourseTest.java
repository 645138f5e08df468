package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.world.Ramp;

/** Courses: what is drawn from a seed is legal, files keep them, and the checker finds faults. */
class CourseTest {
  @TempDir private Path directory;

  @ParameterizedTest
  @ValueSource(longs = 2)
  void course_ofASeed_isLegalAndHasWhatTheRulesName(long seed) {
    Course course = CourseGenerator.course(seed);
    assertThat(CourseChecker.faults(course)).isEmpty();
    assertThat(course.boundaries()).hasSize(4);
    assertThat(course.goals()).hasSize(4);
    assertThat(course.of(Scenery.BARREL)).hasSizeGreaterThan(7);
    assertThat(course.of(Scenery.LINE)).hasSizeGreaterThan(4);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = 1)
  void course_ofAnotherSeed_isLegalAndHasWhatTheRulesName(long seed) {
    course_ofASeed_isLegalAndHasWhatTheRulesName(seed);
  }

  @Test
  void course_ofTheSameSeed_isTheSame() throws Exception {
    assertThat(text(CourseGenerator.course(3))).isEqualTo(text(CourseGenerator.course(3)));
  }

  @Test
  void read_whatWasWritten_isTheSameCourse() throws Exception {
    Course course = CourseGenerator.course(4);
    String written = text(course);
    Course read = CourseFile.read(directory.resolve("course.xml"));
    assertThat(read.goals()).hasSameSizeAs(course.goals());
    assertThat(read.start().headingRad()).isCloseTo(course.start().headingRad(), offset(1.0e-4));
    CourseFile.write(read, directory.resolve("again.xml"));
    assertThat(body(Files.readString(directory.resolve("again.xml")))).isEqualTo(body(written));
  }

  private static Offset<Double> offset(double value) {
    return Offset.offset(value);
  }

  private static String body(String file) {
    return file.substring(file.indexOf("<world>"));
  }

  private String text(Course course) throws Exception {
    Path file = directory.resolve("course.xml");
    CourseFile.write(course, file);
    return Files.readString(file);
  }

  @Test
  void read_courseWithoutAStart_saysWhatIsMissing() throws Exception {
    Path file = directory.resolve("bad.xml");
    Files.writeString(
        file,
        "<world><reference>Local ENU</reference><Circle><uid>w</uid><type>waypoint</type>"
            + "<x>1</x><y>2</y><radius>2</radius></Circle></world>");
    assertThatThrownBy(() -> CourseFile.read(file))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("bad.xml")
        .hasMessageContaining("\"start\"");
  }

  @Test
  void read_courseOnTheEarth_saysWhichFrameIsExpected() throws Exception {
    Path file = directory.resolve("bad.xml");
    Files.writeString(
        file,
        "<world><Circle><uid>w</uid><type>waypoint</type><x>1</x><y>2</y><radius>2</radius></Circle></world>");
    assertThatThrownBy(() -> CourseFile.read(file))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("Local ENU");
  }

  /** A straight lane of 20 m with barrels at these distances from its middle, 10 m ahead. */
  private static Course lane(double widthM, double... barrels) {
    CourseBuilder builder = new CourseBuilder(Point.ORIGIN, 0.7, false);
    builder.start(Point.ORIGIN, Point.of(1.0, 0.0, 0.0));
    builder.waypoint(Point.of(18.0, 0.0, 0.0));
    for (int side = -1; side <= 1; side += 2) {
      List<Point> points = new ArrayList<>();
      for (double x = -1.0; x <= 20.0; x += 0.2) {
        points.add(Point.of(x, 0.5 * side * widthM, 0.0));
      }
      builder.line(Course.BOUNDARY, points);
    }
    for (double x : new double[] {-1.0, 20.0}) {
      double half = 0.5 * widthM;
      builder.line(Course.END, List.of(Point.of(x, -half, 0.0), Point.of(x, half, 0.0)));
    }
    for (double barrel : barrels) {
      builder.barrel(Point.of(10.0, barrel, 0.0));
    }
    return builder.course("lane");
  }

  @Test
  void faults_ofALaneWithAPassage_areNone() {
    // Between barrel and line: 4.0 / 2 + 0.2 - 0.3 - 0.038 = 1.862 m.
    assertThat(CourseChecker.faults(lane(4.0, -0.2))).isEmpty();
  }

  @Test
  void faults_ofABarrelThatLeavesLessThanFiveFeet_nameThePassage() {
    // To both sides: 3.4 / 2 - 0.3 - 0.038 = 1.362 m.
    assertThat(CourseChecker.faults(lane(3.4, 0.0)))
        .singleElement()
        .asString()
        .contains("no passage of 1.524 m leads to waypoint 1");
  }

  @ParameterizedTest
  @ValueSource(doubles = {2.9, 6.3})
  void faults_ofALaneThatIsNot10To20Feet_nameItsWidth(double widthM) {
    assertThat(CourseChecker.faults(lane(widthM))).asString().contains("m wide");
  }

  @ParameterizedTest
  @ValueSource(longs = 3002)
  void course_withARamp_isLegalAndElseWhatItIsWithout(long seed) {
    Course without = CourseGenerator.course(seed, Ramps.NONE);
    Course with = CourseGenerator.course(seed, Ramps.ALL);
    assertThat(without.ramps()).isEmpty();
    assertThat(with.ramps()).hasSize(1);
    assertThat(CourseChecker.faults(with)).isEmpty();
    int before = without.objects().size();
    assertThat(with.objects()).hasSize(before + 1);
    assertThat(with.objects().subList(0, before)).isEqualTo(without.objects());
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = 3001)
  void course_withARampOtherSeed_isLegalAndElseWhatItIsWithout(long seed) {
    course_withARamp_isLegalAndElseWhatItIsWithout(seed);
  }

  @Test
  void read_courseWithARamp_hasTheSameRamp() throws Exception {
    Course course = CourseGenerator.course(3001, Ramps.ALL);
    text(course);
    Ramp read = CourseFile.read(directory.resolve("course.xml")).ramps().get(0).ramp();
    Ramp written = course.ramps().get(0).ramp();
    assertThat(read.highestM()).isCloseTo(written.highestM(), offset(1.0e-4));
    assertThat(read.lengthM()).isCloseTo(written.lengthM(), offset(1.0e-3));
    assertThat(read.widthM()).isCloseTo(written.widthM(), offset(1.0e-4));
  }

  /** The lane of 4 m with a ramp from 5 to 11 m, and something else. */
  private static Course ramped(double slope, double widthM, double barrelM) {
    List<ObjectDescription> objects = new ArrayList<>(lane(4.0).objects());
    for (ObjectDescription line : objects.stream().filter(PolyLine.class::isInstance).toList()) {
      PolyLine paint = new PolyLine();
      paint.points(((PolyLine) line).points()).width(Course.LINE_M);
      paint.uid("paint of " + line.uid()).objectType(Scenery.LINE);
      paint.referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(0.0).z(0.0);
      objects.add(paint);
    }
    CourseBuilder builder = new CourseBuilder(Point.ORIGIN, 0.7, false);
    double up = slope * 2.5;
    objects.add(
        builder.ramp(
            List.of(
                Point.of(5.0, 0.0, 0.0),
                Point.of(7.5, 0.0, up),
                Point.of(8.5, 0.0, up),
                Point.of(11.0, 0.0, 0.0)),
            widthM));
    builder.start(Point.ORIGIN, Point.of(1.0, 0.0, 0.0));
    builder.waypoint(Point.of(18.0, 0.0, 0.0));
    builder.barrel(Point.of(barrelM, -1.6, 0.0));
    objects.add(builder.course("barrel").of(Scenery.BARREL).get(0));
    return new Course("ramped lane", objects);
  }

  @Test
  void faults_ofARampOfTheRules_areNone() {
    assertThat(CourseChecker.faults(ramped(0.15, 4.6, 14.0))).isEmpty();
  }

  @Test
  void faults_ofARampTooSteepTooNarrowOrWithABarrel_nameThem() {
    assertThat(CourseChecker.faults(ramped(0.17, 4.6, 14.0))).asString().contains("0.170");
    assertThat(CourseChecker.faults(ramped(0.15, 2.0, 14.0)))
        .asString()
        .contains("2.00 m wide")
        .contains("0 lines across it");
    assertThat(CourseChecker.faults(ramped(0.15, 3.9, 14.0))).asString().contains("ends beside");
    assertThat(CourseChecker.faults(ramped(0.15, 4.6, 12.0)))
        .asString()
        .contains("ramp 1 has barrel 1 on or beside it");
  }

  @Test
  void read_rampThatDips_saysWhereInWhichFile() throws Exception {
    Path file = directory.resolve("bad.xml");
    text(lane(4.0));
    String dips =
        "<PolyLine><uid>ramp 1</uid><type>ramp</type><points>0 0 0; 2 0 0.1; 3 0 0.4; 6 0"
            + " 0</points><width>4</width></PolyLine></world>";
    Files.writeString(
        file, Files.readString(directory.resolve("course.xml")).replace("</world>", dips));
    assertThatThrownBy(() -> CourseFile.read(file))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("bad.xml")
        .hasMessageContaining("object \"ramp 1\": ramp is not convex");
  }

  @Test
  void isInTheWay_paintAndWaypoints_areNot() {
    Course course = lane(4.0, -0.2);
    assertThat(course.objects().stream().filter(CourseChecker::isInTheWay))
        .extracting(ObjectDescription::objectType)
        .containsExactly(Course.BOUNDARY, Course.BOUNDARY, Course.END, Course.END, Scenery.BARREL);
  }
}
