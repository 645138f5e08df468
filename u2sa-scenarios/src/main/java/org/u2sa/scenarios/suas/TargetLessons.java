package org.u2sa.scenarios.suas;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.vision.survey.TargetTraining;

/** Paints images of single random targets, which train the model of shapes and letters. */
final class TargetLessons {
  private static final int IMAGES_EACH = 15; // of a letter on a shape
  private static final int SIDE_PX = 160;
  private static final double TILT_RAD = Math.toRadians(6.0);
  private static final long SEED = 20_251;

  private TargetLessons() {}

  static String model() {
    Random random = new Random(SEED);
    TargetTraining training = new TargetTraining();
    SurveyPictures.Optics optics =
        new SurveyPictures.Optics(2.0, SIDE_PX, SIDE_PX, SurveyPictures.USUAL.focalPx());
    for (int i = 0; i < BlockLetters.ALL.length(); i++) {
      for (String shape : SuasFieldGenerator.SHAPES) {
        for (int k = 0; k < IMAGES_EACH; k++) {
          lesson(training, optics, shape, BlockLetters.ALL.substring(i, i + 1), random);
        }
      }
    }
    return training.model();
  }

  private static void lesson(
      TargetTraining training,
      SurveyPictures.Optics optics,
      String shape,
      String letter,
      Random random) {
    String[] colours = SuasFieldGenerator.COLOURS;
    int colour = random.nextInt(colours.length);
    int other = (colour + 1 + random.nextInt(colours.length - 1)) % colours.length;
    SuasTarget target =
        new SuasTarget(
            1.0 - 2.0 * random.nextDouble(),
            1.0 - 2.0 * random.nextDouble(),
            0.0,
            1.2 + 0.4 * random.nextDouble(),
            2.0 * Math.PI * random.nextDouble(),
            shape,
            colours[colour],
            letter,
            colours[other]);
    double psi = 2.0 * Math.PI * random.nextDouble();
    double roll = TILT_RAD * 0.2 * random.nextGaussian();
    double pitch = TILT_RAD * 0.2 * random.nextGaussian();
    double up = 45.0 + 20.0 * random.nextDouble();
    VehicleTruth truth =
        new VehicleTruth(
            random.nextDouble(),
            Point.of(0.0, 0.0, up),
            new Attitude(roll, pitch, psi),
            Point.ORIGIN,
            Point.ORIGIN,
            Point.ORIGIN);
    byte[] pixels = new FieldPainter(List.of(target), optics, random.nextLong()).picture(truth);
    training.learn(
        new CameraFrame(
            0L,
            SIDE_PX,
            SIDE_PX,
            CameraFrame.PixelFormat.RGB24,
            pixels,
            Optional.of(optics.intrinsics())),
        shape,
        letter,
        target.headingRad() - psi);
  }
}
