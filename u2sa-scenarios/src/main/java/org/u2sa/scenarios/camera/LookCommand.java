package org.u2sa.scenarios.camera;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import javax.imageio.ImageIO;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.camera.CourseVariables;
import org.u2sa.vision.camera.PictureReading;
import org.u2sa.vision.camera.SeenMessages;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa camera look}: shows the detections in images. */
@Command(
    name = "look",
    description = {
      "Show what is detected in pictures: a table, and each picture with its detections",
      "beside a bird's-eye view of the ground."
    })
final class LookCommand implements Callable<Integer> {
  private static final double PATIENCE_S = 10.0;

  @Spec private CommandSpec command;

  @Parameters(paramLabel = "PICTURE", arity = "0..*", description = "PNG or JPEG files.")
  private List<Path> files = new ArrayList<>();

  @Option(
      names = "--configuration",
      paramLabel = "FILE",
      description =
          "Configuration file of a CourseCamera: its mounting, calibration and object types.")
  private Path configuration;

  @Option(names = "--live", description = "Take a picture with its camera.")
  private boolean live;

  @Option(
      names = "--height",
      description = "Height of the camera above the ground in metres, instead of MOUNTED Z.")
  private Double heightM;

  @Option(names = "--down", description = "Downward tilt in degrees, instead of MOUNTED PITCH.")
  private Double downDeg;

  @Option(
      names = "--out",
      defaultValue = "out/camera",
      description = "Folder for the pictures (default: ${DEFAULT-VALUE}).")
  private Path out;

  @Override
  public Integer call() throws IOException, InterruptedException {
    if (files.isEmpty() && !live) {
      throw new BadInputException("no pictures: expected files, or --live");
    }
    if (live && configuration == null) {
      throw new BadInputException("--live: expected --configuration with the camera's file");
    }
    XmlConfiguration settings =
        configuration == null
            ? XmlConfiguration.inMemory("the command line", Map.of())
            : XmlConfiguration.load(configuration);
    PictureReading reading =
        new PictureReading(
            settings.settings(CourseVariables.class).get(),
            mounted(settings.settings(MountingPose.class).get()),
            "Camera",
            settings::resolve);
    Files.createDirectories(out);
    PrintWriter text = command.commandLine().getOut();
    for (Path file : files) {
      look(file.getFileName().toString(), CameraPicture.read(file), reading, text);
    }
    if (live) {
      Path logs = Files.createTempDirectory("u2sa-camera"); // of this account only
      try (LiveCamera camera = new LiveCamera(settings, logs)) {
        look("live", reading.unpacked(camera.next(0.0, PATIENCE_S)), reading, text);
      }
    }
    return ExitCode.DONE;
  }

  private MountingPose mounted(MountingPose pose) {
    return new MountingPose(
        pose.x(),
        pose.y(),
        heightM == null ? pose.z() : -heightM,
        pose.roll(),
        downDeg == null ? pose.pitch() : -Math.toRadians(downDeg),
        pose.yaw());
  }

  private void look(String name, CameraFrame frame, PictureReading reading, PrintWriter text)
      throws IOException {
    Seen seen;
    try {
      seen = reading.read(frame, 0.0, 0.0, 0.0);
    } catch (IllegalArgumentException e) {
      throw new BadInputException(name + ": " + e.getMessage(), e);
    }
    text.printf("%s, camera %s:%n", name, reading.lens());
    TextTable table = new TextTable("SEEN", "AHEAD", "LEFT", "SIGMA", "CONFIDENCE");
    boolean isEmpty = true;
    for (ObjectDescription object : reading.messages(seen, 0.0, 0.0, 0.0, 0L)) {
      if (object.objectType().equals(SeenMessages.NOTHING)) {
        continue;
      }
      isEmpty = false;
      Point sigma = object.motion().sigma().orElseThrow();
      table.add(
          object.objectType(),
          String.format(Locale.ROOT, "%.2f m", object.x()),
          String.format(Locale.ROOT, "%.2f m", object.y()),
          String.format(Locale.ROOT, "%.2f, %.2f m", sigma.x(), sigma.y()),
          String.format(Locale.ROOT, "%.2f", object.confidence().orElse(0.0)));
    }
    (isEmpty ? List.of("nothing seen") : table.lines()).forEach(text::println);
    Path picture = out.resolve(withoutEnding(name) + "-seen.png");
    ImageIO.write(SeenPicture.of(frame, seen, reading.sight()), "png", picture.toFile());
    text.println("wrote " + picture);
  }

  private static String withoutEnding(String name) {
    int dot = name.lastIndexOf('.');
    return dot > 0 ? name.substring(0, dot) : name;
  }
}
