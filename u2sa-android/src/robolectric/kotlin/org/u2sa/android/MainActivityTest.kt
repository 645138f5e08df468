package org.u2sa.android

import org.assertj.core.api.Assertions.assertThat
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.RobolectricTestRunner
import org.robolectric.annotation.Config

@RunWith(RobolectricTestRunner::class)
@Config(sdk = [28, 35])
class MainActivityTest {
    @Test
    fun onCreate_firstStart_showsThatNothingRuns() {
        Robolectric.buildActivity(MainActivity::class.java).use { controller ->
            val activity = controller.setup().get()
            assertThat(activity.title.toString()).isEqualTo("U2SA")
        }
    }
}
