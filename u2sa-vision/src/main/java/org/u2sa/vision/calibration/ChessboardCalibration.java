package org.u2sa.vision.calibration;

import boofcv.abst.fiducial.calib.ConfigGridDimen;
import boofcv.abst.geo.calibration.CalibrateMonoPlanar;
import boofcv.abst.geo.calibration.DetectSingleFiducialCalibration;
import boofcv.abst.geo.calibration.ImageResults;
import boofcv.alg.geo.calibration.CalibrationObservation;
import boofcv.factory.fiducial.FactoryFiducialCalibration;
import boofcv.struct.calib.CameraPinholeBrown;
import boofcv.struct.geo.PointIndex2D_F64;
import boofcv.struct.image.GrayF32;
import java.util.ArrayList;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.lens.LensCalibration.Spot;

/**
 * Calibrates a camera from images of a chessboard at several positions and tilts (Zhang, A Flexible
 * New Technique for Camera Calibration, IEEE PAMI 22, 2000). Takes seconds, so it is for commands,
 * not for control loops.
 */
public final class ChessboardCalibration {
  /** Minimum number of board images for a well-determined geometry. */
  public static final int FEWEST = 4;

  private static final int RADIAL = 2; // k1 and k2: a third one is poorly determined by few images
  private static final double LARGEST_ERROR_PX = 3.0;
  private static final double MIN_TILT = Math.toRadians(10.0); // between two images
  private static final double HALF = 0.5; // BoofCV's 0 is a pixel's edge, ours its centre

  private final Chessboard board;
  private final DetectSingleFiducialCalibration detector;
  private final List<String> names = new ArrayList<>();
  private final List<CalibrationObservation> found = new ArrayList<>(); // null if no board
  private int width;
  private int height;

  /**
   * A calibration and the residuals of each image.
   *
   * @param pictures in the order added
   */
  public record Result(LensCalibration lens, List<BoardPicture> pictures) {}

  public ChessboardCalibration(Chessboard board) {
    this.board = board;
    detector =
        FactoryFiducialCalibration.chessboardX(
            null, new ConfigGridDimen(board.rows() + 1, board.columns() + 1, board.squareM()));
  }

  /**
   * Detects the board in an image.
   *
   * @param name image name, for messages
   * @return whether a complete board was found
   * @throws BadInputException if the image size differs from earlier ones
   */
  public boolean add(String name, CameraFrame picture) {
    if (names.isEmpty()) {
      width = picture.width();
      height = picture.height();
    } else if (picture.width() != width || picture.height() != height) {
      throw new BadInputException(
          String.format(
              "%s has %d x %d pixels, %s %d x %d: all pictures of one camera must have the same "
                  + "size",
              name, picture.width(), picture.height(), names.get(0), width, height));
    }
    boolean isThere = detector.process(grey(picture));
    names.add(name);
    found.add(isThere ? detector.getDetectedPoints().copy() : null);
    return isThere;
  }

  /** Number of images that show the board. */
  public int boards() {
    return (int) found.stream().filter(each -> each != null).count();
  }

  private static GrayF32 grey(CameraFrame picture) {
    if (picture.format() == PixelFormat.JPEG) {
      throw new IllegalArgumentException("a JPEG picture has no pixels yet");
    }
    GrayF32 grey = new GrayF32(picture.width(), picture.height());
    byte[] from = picture.pixels();
    boolean isGrey = picture.format() == PixelFormat.GREY8;
    for (int i = 0; i < grey.data.length; i++) {
      grey.data[i] =
          isGrey
              ? from[i] & 0xFF
              : 0.299f * (from[3 * i] & 0xFF) // ITU-R BT.601
                  + 0.587f * (from[3 * i + 1] & 0xFF)
                  + 0.114f * (from[3 * i + 2] & 0xFF);
    }
    return grey;
  }

  /**
   * Computes the calibration.
   *
   * @throws BadInputException if too few images show the board, or they do not determine the
   *     geometry
   */
  public Result calibrate() {
    if (boards() < FEWEST) {
      throw new BadInputException(
          String.format(
              "%d of %d pictures show a complete board of %s: expected at least %d, with the board tilted "
                  + "differently in each",
              boards(), names.size(), board, FEWEST));
    }
    CalibrateMonoPlanar calibrator = new CalibrateMonoPlanar();
    calibrator.initialize(width, height, List.of(detector.getLayout()));
    calibrator.configurePinhole(true, RADIAL, true);
    found.stream().filter(each -> each != null).forEach(calibrator::addImage);
    CameraPinholeBrown brown;
    try {
      brown = calibrator.process();
    } catch (RuntimeException e) { // thrown by BoofCV for degenerate views
      throw new BadInputException(undetermined(), e);
    }
    if (tilt(calibrator) < MIN_TILT) {
      throw new BadInputException(undetermined());
    }
    double error = rootMeanSquare(calibrator.getErrors());
    boolean isPossible = brown.fx > 0.0 && brown.fy > 0.0 && error < LARGEST_ERROR_PX;
    if (!isPossible || !Double.isFinite(brown.fx + brown.fy + brown.cx + brown.cy)) {
      throw new BadInputException(undetermined());
    }
    LensCalibration lens =
        new LensCalibration(
            width,
            height,
            new Intrinsics(brown.fx, brown.fy, brown.cx - HALF, brown.cy - HALF),
            brown.radial[0],
            brown.radial[1],
            brown.t1,
            brown.t2,
            0.0,
            error,
            boards());
    return new Result(lens, pictures(calibrator.getErrors()));
  }

  private static String undetermined() {
    return "the pictures do not determine the camera: show the board tilted in several ways, near "
        + "the corners of the picture too";
  }

  /** Largest angle between the boards of two images [rad]: parallel boards are degenerate. */
  private double tilt(CalibrateMonoPlanar calibrator) {
    double least = 1.0; // cosine
    for (int i = 0; i < boards(); i++) {
      for (int k = 0; k < i; k++) {
        DMatrixRMaj a = calibrator.getTargetToView(i).getR();
        DMatrixRMaj b = calibrator.getTargetToView(k).getR();
        double cosine = 0.0;
        for (int row = 0; row < 3; row++) {
          cosine += a.get(row, 2) * b.get(row, 2); // of the boards' normals
        }
        least = Math.min(least, cosine);
      }
    }
    return Math.acos(Math.max(-1.0, Math.min(1.0, least)));
  }

  private static double rootMeanSquare(List<ImageResults> errors) {
    double squares = 0.0;
    int count = 0;
    for (ImageResults each : errors) {
      for (double error : each.pointError) {
        squares += error * error;
        count++;
      }
    }
    return Math.sqrt(squares / count);
  }

  private List<BoardPicture> pictures(List<ImageResults> errors) {
    List<BoardPicture> pictures = new ArrayList<>();
    int at = 0;
    for (int i = 0; i < names.size(); i++) {
      if (found.get(i) == null) {
        pictures.add(new BoardPicture(names.get(i), List.of(), 0.0));
        continue;
      }
      List<Spot> corners = new ArrayList<>();
      for (PointIndex2D_F64 point : found.get(i).points) {
        corners.add(new Spot(point.p.x - HALF, point.p.y - HALF));
      }
      pictures.add(new BoardPicture(names.get(i), corners, errors.get(at++).meanError));
    }
    return pictures;
  }
}
