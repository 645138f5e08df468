package org.u2sa.android.log

import android.util.Log
import org.assertj.core.api.Assertions.assertThat
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.shadows.ShadowLog

@RunWith(RobolectricTestRunner::class)
class LogcatProviderTest {
    private val logger = LogcatProvider().apply { initialize() }.loggerFactory.getLogger("io.moquette.broker.Server")

    @Test
    fun warn_withArgumentsAndCause_isInAndroidsLog() {
        logger.warn("client {} left", "a", IllegalStateException("why"))

        val line = ShadowLog.getLogsForTag("u2sa").single()
        assertThat(line.type).isEqualTo(Log.WARN)
        assertThat(line.msg).startsWith("Server: client a left").contains("IllegalStateException: why")
    }

    @Test
    fun info_unlessADeveloperAsksForIt_isLeftOut() {
        logger.info("chatter")
        assertThat(ShadowLog.getLogsForTag("u2sa")).isEmpty()

        ShadowLog.setLoggable("u2sa", Log.DEBUG)
        logger.info("chatter")
        assertThat(ShadowLog.getLogsForTag("u2sa").single().msg).isEqualTo("Server: chatter")
    }
}
