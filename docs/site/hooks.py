"""What MkDocs asks while it makes one language of the site."""
import re

OTHER = {"en": ("el", "Ελληνικά"), "el": ("en", "English")}


def on_page_content(html, page, config, files):
    """Each page begins with the way to the same page in the other language; figures speak the page's."""
    language, _, name = page.file.url.partition("/")
    other, words = OTHER[language]
    html = re.sub(r'(href="\.\./figures/\w+\.html)"', rf'\1?lang={language}"', html)
    return f'<a class="language" lang="{other}" hreflang="{other}" href="../{other}/{name}">{words}</a>\n{html}'
