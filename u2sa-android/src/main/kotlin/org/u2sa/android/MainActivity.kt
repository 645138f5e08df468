package org.u2sa.android

import android.app.Activity
import android.os.Bundle
import android.widget.TextView

/** The first screen. */
class MainActivity : Activity() {
    override fun onCreate(savedInstanceState: Bundle?) {
        super.onCreate(savedInstanceState)
        setContentView(TextView(this).apply { text = applicationInfo.loadLabel(packageManager) })
    }
}
