package org.u2sa.scenarios.camera;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.vision.calibration.BoardPicture;
import org.u2sa.vision.calibration.Chessboard;
import org.u2sa.vision.calibration.ChessboardCalibration;
import org.u2sa.vision.lens.CalibrationFile;
import org.u2sa.vision.lens.LensCalibration;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa camera calibrate}: measures a camera's geometry with a chessboard. */
@Command(
    name = "calibrate",
    description = {
      "Measure a camera's geometry with pictures of a printed chessboard.",
      "",
      "Take 10 to 20 pictures with the board tilted differently in each, and near the corners in some. "
          + "Exit code 1: the pictures do not determine the camera."
    })
final class CalibrateCommand implements Callable<Integer> {
  private static final double BETWEEN_S = 1.0;
  private static final double PATIENCE_S = 10.0;

  @Spec private CommandSpec command;

  @Parameters(paramLabel = "PICTURE", arity = "0..*", description = "PNG or JPEG files.")
  private List<Path> files = new ArrayList<>();

  @Option(
      names = "--live",
      paramLabel = "FILE",
      description = "Take the pictures with the camera of this configuration file.")
  private Path live;

  @Option(
      names = "--pictures",
      defaultValue = "15",
      description =
          "With --live: number of pictures that show the board (default: ${DEFAULT-VALUE}).")
  private int wanted;

  @Option(
      names = "--board",
      defaultValue = "9x6",
      description =
          "Inner corners of the board, where four squares meet (default: ${DEFAULT-VALUE}).")
  private String corners;

  @Option(
      names = "--square",
      defaultValue = "0.025",
      description = "Edge of a square in metres (default: ${DEFAULT-VALUE}).")
  private double squareM;

  @Option(
      names = "--out",
      defaultValue = "camera.xml",
      description = "Calibration file to write (default: ${DEFAULT-VALUE}).")
  private Path out;

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter text = command.commandLine().getOut();
    ChessboardCalibration calibration =
        new ChessboardCalibration(Chessboard.parse(corners, squareM));
    if (live == null && files.isEmpty()) {
      throw new BadInputException("no pictures: expected files, or --live with a configuration");
    }
    for (Path file : files) {
      told(file.toString(), calibration.add(file.toString(), CameraPicture.read(file)), text);
    }
    if (live != null) {
      take(calibration, text);
    }
    ChessboardCalibration.Result result;
    try {
      result = calibration.calibrate();
    } catch (BadInputException e) {
      command.commandLine().getErr().println(e.getMessage());
      return ExitCode.FAILED;
    }
    for (BoardPicture picture : result.pictures()) {
      if (picture.hasBoard()) {
        text.printf(Locale.ROOT, "%-40s %.2f px%n", picture.name(), picture.errorPx());
      }
    }
    CalibrationFile.write(result.lens(), out);
    say(result.lens(), text);
    return ExitCode.DONE;
  }

  private static void told(String name, boolean isThere, PrintWriter text) {
    if (!isThere) {
      text.println(name + ": no complete board found");
    }
  }

  private void take(ChessboardCalibration calibration, PrintWriter text)
      throws IOException, InterruptedException {
    Path logs = Files.createTempDirectory("u2sa-camera"); // of this account only
    try (LiveCamera camera = new LiveCamera(XmlConfiguration.load(live), logs)) {
      for (int tries = 1; calibration.boards() < wanted && tries <= 10 * wanted; tries++) {
        CameraFrame frame = camera.next(BETWEEN_S, PATIENCE_S);
        CameraFrame pixels =
            frame.format() == PixelFormat.JPEG ? new ImageIoJpeg().decode(frame) : frame;
        told("picture " + tries, calibration.add("picture " + tries, pixels), text);
        text.printf("%d of %d pictures show the board%n", calibration.boards(), wanted);
        text.flush();
      }
    }
  }

  private void say(LensCalibration lens, PrintWriter text) {
    text.printf(
        Locale.ROOT,
        "%d pictures of %d x %d: focal length %.2f, %.2f px, centre %.2f, %.2f px%n"
            + "distortion k1 %.4f, k2 %.4f, p1 %.5f, p2 %.5f; reprojection error %.3f px%n",
        lens.pictures(),
        lens.width(),
        lens.height(),
        lens.pinhole().focalX(),
        lens.pinhole().focalY(),
        lens.pinhole().centreX(),
        lens.pinhole().centreY(),
        lens.k1(),
        lens.k2(),
        lens.p1(),
        lens.p2(),
        lens.errorPx());
    text.println("wrote " + out);
  }
}
