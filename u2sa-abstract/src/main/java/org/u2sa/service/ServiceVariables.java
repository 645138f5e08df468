package org.u2sa.service;

import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.log.LogLevelEnum;

/** The configuration variables that every service has. */
final class ServiceVariables {
  static final VariableDeclaration<String> SERVICE_NAME =
      VariableDeclaration.text("SERVICE NAME")
          .ifAbsent("")
          .describedAs(
              "Name of the service, unique within the system; empty: the class's own name for itself.");

  static final VariableDeclaration<String> LOG_LEVEL =
      VariableDeclaration.text("LOG LEVEL")
          .ifAbsent(LogLevelEnum.INFO.name())
          .oneOf(
              LogLevelEnum.DEBUG.name(),
              LogLevelEnum.INFO.name(),
              LogLevelEnum.WARN.name(),
              LogLevelEnum.ERROR.name())
          .describedAs("Lowest level that is written to the log file.");

  static final VariableDeclaration<String> LOG_PATH =
      VariableDeclaration.text("LOG PATH")
          .ifAbsent("")
          .describedAs("Directory of the log file; empty: the run's own directory.");

  static final VariableDeclaration<String> MANAGER_IP =
      VariableDeclaration.text("COMMUNICATION MANAGER IP")
          .ifAbsent("localhost")
          .describedAs("Host of the Communication Manager, if it runs in another process.");

  static final VariableDeclaration<Integer> MANAGER_PORT =
      VariableDeclaration.integer("COMMUNICATION MANAGER PORT")
          .range(Range.of(1, 65_535))
          .ifAbsent(1883)
          .describedAs("TCP port of the Communication Manager, if it runs in another process.");

  static final VariableDeclaration<Integer> INBOX_CAPACITY =
      VariableDeclaration.integer("INBOX CAPACITY")
          .range(Range.of(1, 1_000_000))
          .ifAbsent(1024)
          .describedAs(
              "Messages that wait for the service before further ones are dropped and counted.");

  static final VariableDeclaration<Double> HEALTH_INTERVAL =
      VariableDeclaration.number("HEALTH INTERVAL", "s")
          .range(Range.of(0.01, 3600.0))
          .ifAbsent(0.25)
          .describedAs("Time between two health reports.");

  static final VariableDeclaration<Integer> MAX_ERRORS_IN_A_ROW =
      VariableDeclaration.integer("MAX ERRORS IN A ROW")
          .range(Range.of(1, 1_000_000))
          .ifAbsent(10)
          .describedAs("Exceptions one after the other at which the service kills itself.");

  private ServiceVariables() {}
}
