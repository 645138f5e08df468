package org.u2sa.android.log

import android.util.Log
import org.slf4j.Marker
import org.slf4j.event.Level
import org.slf4j.helpers.LegacyAbstractLogger
import org.slf4j.helpers.MessageFormatter

/** SLF4J logger that writes to logcat; levels below WARN require `setprop log.tag.u2sa DEBUG`. */
internal class LogcatLogger(loggerName: String) : LegacyAbstractLogger() {
    private val tag = loggerName.substringAfterLast('.')

    init {
        name = loggerName
    }

    override fun isTraceEnabled() = Log.isLoggable(TAG, Log.VERBOSE)

    override fun isDebugEnabled() = Log.isLoggable(TAG, Log.DEBUG)

    override fun isInfoEnabled() = isDebugEnabled // INFO is on by default, and libraries log too much at that level

    override fun isWarnEnabled() = true

    override fun isErrorEnabled() = true

    override fun getFullyQualifiedCallerName(): String? = null

    override fun handleNormalizedLoggingCall(
        level: Level,
        marker: Marker?,
        pattern: String?,
        arguments: Array<Any?>?,
        thrown: Throwable?,
    ) {
        val message = MessageFormatter.basicArrayFormat(pattern, arguments)
        val whole = if (thrown == null) "$tag: $message" else "$tag: $message\n${Log.getStackTraceString(thrown)}"
        Log.println(priority(level), TAG, whole)
    }

    private fun priority(level: Level) = when (level) {
        Level.TRACE -> Log.VERBOSE
        Level.DEBUG -> Log.DEBUG
        Level.INFO -> Log.INFO
        Level.WARN -> Log.WARN
        Level.ERROR -> Log.ERROR
    }

    private companion object {
        const val TAG = "u2sa"
        const val serialVersionUID = 1L
    }
}
