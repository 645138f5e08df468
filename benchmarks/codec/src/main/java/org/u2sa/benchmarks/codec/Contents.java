package org.u2sa.benchmarks.codec;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.benchmarks.codec.proto.Percentage;
import org.u2sa.benchmarks.codec.proto.Scan;
import org.u2sa.benchmarks.codec.proto.State;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;

/** The same contents, as each of the codecs has them: a command, a state, a scan of 360 beams. */
enum Contents {
  COMMAND {
    @Override
    U2SAData ours() {
      PercentageCommand command = PercentageCommand.of("Left motor", 37.5);
      command.systemId("ugv");
      command.timestamp(TIMESTAMP);
      return command;
    }

    @Override
    Object bean() {
      CommandBean bean = new CommandBean();
      bean.systemId = "ugv";
      bean.timestamp = TIMESTAMP;
      bean.actuatorName = "Left motor";
      bean.percentage = 37.5;
      return bean;
    }

    @Override
    com.google.protobuf.Message protobuf() {
      return Percentage.newBuilder()
          .setSystemId("ugv")
          .setTimestamp(TIMESTAMP)
          .setServiceName("Left motor")
          .setPercentage(37.5)
          .build();
    }
  },
  STATE {
    @Override
    U2SAData ours() {
      StateInformation state =
          new StateInformation()
              .sensorName("State Estimator")
              .referenceFrame(ReferenceFrame.GLOBAL)
              .x(value(1)).y(value(2)).z(value(3))
              .xDot(value(4)).yDot(value(5)).zDot(value(6))
              .xDoubleDot(value(7)).yDoubleDot(value(8)).zDoubleDot(value(9))
              .xSigma(value(10)).ySigma(value(11)).zSigma(value(12))
              .phi(value(13)).theta(value(14)).psi(value(15))
              .phiDot(value(16)).thetaDot(value(17)).psiDot(value(18))
              .phiSigma(value(19)).thetaSigma(value(20)).psiSigma(value(21));
      state.systemId("ugv");
      state.timestamp(TIMESTAMP);
      return state;
    }

    @Override
    Object bean() {
      StateBean bean = new StateBean();
      bean.systemId = "ugv";
      bean.timestamp = TIMESTAMP;
      bean.sensorName = "State Estimator";
      bean.referenceFrame = "GLOBAL";
      bean.x = value(1); bean.y = value(2); bean.z = value(3);
      bean.xDot = value(4); bean.yDot = value(5); bean.zDot = value(6);
      bean.xDoubleDot = value(7); bean.yDoubleDot = value(8); bean.zDoubleDot = value(9);
      bean.xSigma = value(10); bean.ySigma = value(11); bean.zSigma = value(12);
      bean.phi = value(13); bean.theta = value(14); bean.psi = value(15);
      bean.phiDot = value(16); bean.thetaDot = value(17); bean.psiDot = value(18);
      bean.phiSigma = value(19); bean.thetaSigma = value(20); bean.psiSigma = value(21);
      return bean;
    }

    @Override
    com.google.protobuf.Message protobuf() {
      return State.newBuilder()
          .setSystemId("ugv")
          .setTimestamp(TIMESTAMP)
          .setSensorName("State Estimator")
          .setReferenceFrame(1)
          .setX(value(1)).setY(value(2)).setZ(value(3))
          .setXDot(value(4)).setYDot(value(5)).setZDot(value(6))
          .setXDoubleDot(value(7)).setYDoubleDot(value(8)).setZDoubleDot(value(9))
          .setXSigma(value(10)).setYSigma(value(11)).setZSigma(value(12))
          .setPhi(value(13)).setTheta(value(14)).setPsi(value(15))
          .setPhiDot(value(16)).setThetaDot(value(17)).setPsiDot(value(18))
          .setPhiSigma(value(19)).setThetaSigma(value(20)).setPsiSigma(value(21))
          .build();
    }
  },
  SCAN {
    @Override
    U2SAData ours() {
      List<OptionalDouble> ranges = new ArrayList<>();
      for (int beam = 0; beam < BEAMS; beam++) {
        ranges.add(beam % 10 == 0 ? OptionalDouble.empty() : OptionalDouble.of(value(beam)));
      }
      RangeScan scan =
          new RangeScan()
              .sensorName("Laser")
              .minRange(0.1)
              .maxRange(30.0)
              .beams(-Math.PI, Math.toRadians(1.0), ranges);
      scan.systemId("ugv");
      scan.timestamp(TIMESTAMP);
      return scan;
    }

    @Override
    Object bean() {
      ScanBean bean = new ScanBean();
      bean.systemId = "ugv";
      bean.timestamp = TIMESTAMP;
      bean.sensorName = "Laser";
      bean.minRange = 0.1;
      bean.maxRange = 30.0;
      bean.startAngle = -Math.PI;
      bean.angleIncrement = Math.toRadians(1.0);
      bean.ranges = new double[BEAMS];
      bean.returns = new boolean[BEAMS];
      for (int beam = 0; beam < BEAMS; beam++) {
        bean.returns[beam] = beam % 10 != 0;
        bean.ranges[beam] = bean.returns[beam] ? value(beam) : 0.0;
      }
      return bean;
    }

    @Override
    com.google.protobuf.Message protobuf() {
      Scan.Builder scan =
          Scan.newBuilder()
              .setSystemId("ugv")
              .setTimestamp(TIMESTAMP)
              .setSensorName("Laser")
              .setMinRange(0.1)
              .setMaxRange(30.0)
              .setStartAngle(-Math.PI)
              .setAngleIncrement(Math.toRadians(1.0));
      for (int beam = 0; beam < BEAMS; beam++) {
        scan.addRanges(beam % 10 == 0 ? 0.0 : value(beam)).addReturns(beam % 10 != 0);
      }
      return scan.build();
    }
  };

  private static final int BEAMS = 360;
  private static final long TIMESTAMP = 1_790_000_000_123_456L; // microseconds since 1970

  abstract U2SAData ours();

  abstract Object bean();

  abstract com.google.protobuf.Message protobuf();

  /** A number with all its digits, as measured ones have them. */
  private static double value(int i) {
    return 1.0 + Math.abs(Math.sin(i));
  }

  /** For Jackson and Java's own serialization. */
  public static final class CommandBean implements Serializable {
    private static final long serialVersionUID = 1L;
    public String systemId;
    public long timestamp;
    public String actuatorName;
    public double percentage;
  }

  /** For Jackson and Java's own serialization. */
  public static final class StateBean implements Serializable {
    private static final long serialVersionUID = 1L;
    public String systemId;
    public long timestamp;
    public String sensorName;
    public String referenceFrame;
    public double x, y, z, xDot, yDot, zDot, xDoubleDot, yDoubleDot, zDoubleDot, xSigma, ySigma, zSigma;
    public double phi, theta, psi, phiDot, thetaDot, psiDot, phiSigma, thetaSigma, psiSigma;
  }

  /** For Jackson and Java's own serialization. */
  public static final class ScanBean implements Serializable {
    private static final long serialVersionUID = 1L;
    public String systemId;
    public long timestamp;
    public String sensorName;
    public double minRange, maxRange, startAngle, angleIncrement;
    public double[] ranges;
    public boolean[] returns;
  }
}
