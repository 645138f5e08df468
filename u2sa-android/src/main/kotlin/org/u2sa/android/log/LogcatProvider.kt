package org.u2sa.android.log

import java.util.concurrent.ConcurrentHashMap
import org.slf4j.ILoggerFactory
import org.slf4j.IMarkerFactory
import org.slf4j.Logger
import org.slf4j.helpers.BasicMarkerFactory
import org.slf4j.helpers.NOPMDCAdapter
import org.slf4j.spi.MDCAdapter
import org.slf4j.spi.SLF4JServiceProvider

/**
 * Routes library logs (Moquette) to logcat; services have their own log files. Found by SLF4J through META-INF/services.
 */
class LogcatProvider : SLF4JServiceProvider {
    private val loggers = ConcurrentHashMap<String, Logger>()
    private val markers = BasicMarkerFactory()
    private val contexts = NOPMDCAdapter()

    override fun getLoggerFactory() = ILoggerFactory { name -> loggers.getOrPut(name) { LogcatLogger(name) } }

    override fun getMarkerFactory(): IMarkerFactory = markers

    override fun getMDCAdapter(): MDCAdapter = contexts

    override fun getRequestedApiVersion() = "2.0.99" // any SLF4J 2.0 version

    override fun initialize() = Unit
}
