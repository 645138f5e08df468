package org.u2sa.service;

import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;

/** The configuration variables that every service has. */
record ServiceVariables(
    @Variable(
            ifAbsentText = "",
            text =
                "Name of the service, unique within the system; empty: the default of its class.")
        String serviceName,
    @Variable(ifAbsentText = "", text = "Directory of the log file; empty: that of the run.")
        String logPath,
    @Variable(ifAbsentText = "INFO", text = "Lowest level written to the log file.")
        LogLevelEnum logLevel,
    @Variable(
            name = "MAX ERRORS IN A ROW",
            min = 1,
            max = 1_000_000,
            ifAbsent = 10,
            text = "Consecutive exceptions after which the service stops as failed.")
        int maxErrorsInARow,
    @Variable(
            unit = "s",
            min = 0.01,
            max = 3600,
            ifAbsent = 0.25,
            text = "Time between two health reports.")
        double healthInterval,
    @Variable(
            min = 1,
            max = 1_000_000,
            ifAbsent = 1024,
            text = "Messages that may wait for the service; further ones are dropped and counted.")
        int inboxCapacity) {}
