// SPDX-License-Identifier: MIT
#include "core/text/html_text.h"

#include "core/text/number_text.h"

namespace core {

const char* const kReportStyle =
    "body{font:15px/1.5 sans-serif;color:#1f2328;max-width:1080px;margin:24px auto;padding:0 18px}\n"
    "h1{font-size:24px}h2{font-size:19px;margin-top:36px}\n"
    "table{border-collapse:collapse;font-variant-numeric:tabular-nums;margin:12px 0}\n"
    "th,td{padding:3px 12px;border-bottom:1px solid #dfe2e6;text-align:right;white-space:nowrap}\n"
    "th:first-child,td.text{text-align:left;white-space:normal;font-weight:normal}\n"
    "thead th{border-bottom:2px solid #8b949e}tr.paper{color:#6e7781;font-style:italic}\n"
    "figure{margin:18px 0}figure svg{width:100%;height:auto;max-width:860px}figcaption{color:#57606a}\n"
    "code{background:#f3f4f6;padding:1px "
    "5px;border-radius:3px}.no{color:#b42318}.yes{color:#17703a}.open{color:#8a6d00}\n";

std::string htmlEscaped(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += c;
        }
    }
    return escaped;
}

std::string htmlTextCell(const std::string& text) {
    return "<td class=\"text\">" + htmlEscaped(text) + "</td>";
}

std::string htmlNumberCell(double value, int digits) {
    return "<td>" + fixedText(value, digits) + "</td>";
}

} // namespace core
